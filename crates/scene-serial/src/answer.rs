use core::fmt;

/// The board's reply to a transfer. It is sent as a line of text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Answer<W> {
    /// The board draws the scene.
    Shown {
        /// Ticket of the scene.
        ticket: u16,
    },
    /// The transfer succeeded, but the board cannot draw the scene.
    Refused {
        /// Ticket of the scene.
        ticket: u16,
        /// Reason why the board cannot draw the scene, as text.
        why: W,
    },
    /// The transfer failed.
    Broken {
        /// Reason why the transfer failed, as text.
        why: W,
    },
}

impl<W: fmt::Display> fmt::Display for Answer<W> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shown { ticket } => write!(f, "shown {ticket:04x}"),
            Self::Refused { ticket, why } => write!(f, "refused {ticket:04x}: {why}"),
            Self::Broken { why } => write!(f, "broken: {why}"),
        }
    }
}

impl<'l> Answer<&'l str> {
    /// Parses an answer from a line of text. The line must not include its line end.
    /// Returns `None` if the line is not an answer.
    pub fn parse(line: &'l str) -> Option<Self> {
        let ticket = |digits| u16::from_str_radix(digits, 16).ok();
        let (head, why) = match line.split_once(": ") {
            Some((head, why)) => (head, Some(why)),
            None => (line, None),
        };
        match (head.split_once(' '), why) {
            (Some(("shown", digits)), None) => Some(Self::Shown {
                ticket: ticket(digits)?,
            }),
            (Some(("refused", digits)), Some(why)) => Some(Self::Refused {
                ticket: ticket(digits)?,
                why,
            }),
            (None, Some(why)) if head == "broken" => Some(Self::Broken { why }),
            _ => None,
        }
    }
}
