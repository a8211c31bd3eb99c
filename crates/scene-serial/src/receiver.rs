use core::fmt;

use cobs::{DecodeResult, DecoderState};
use heapless::Vec;

use crate::frame::checksum;

/// Takes frames byte by byte, with room for so many bytes: those of a scene and 6 more.
///
/// It does nothing else: no time, no wires.
#[derive(Debug)]
pub struct Receiver<const ROOM: usize> {
    decoder: DecoderState,
    bytes: Vec<u8, ROOM>,
    progress: Progress,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Progress {
    /// Nothing came after the last end of a frame.
    Waiting,
    Receiving,
    /// Longer than there is room for: left out up to its end.
    TooLong,
    /// The bytes are a message.
    Received,
}

/// A scene that arrived.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Message<'m> {
    /// The host's, to be sent back with the answer.
    pub ticket: u16,
    /// As it was compiled; whether it is a scene is not known yet.
    pub scene: &'m [u8],
}

/// Why what was received is no message.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Broken {
    /// Bytes were changed, lost or added, or are of something else.
    Damaged,
    /// Longer than there is room for.
    TooLong {
        /// The most bytes that a scene may have.
        most: usize,
    },
    /// It did not go on.
    Stalled,
}

impl fmt::Display for Broken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Damaged => f.write_str("damaged on its way"),
            Self::TooLong { most } => write!(f, "longer than the {most} bytes there is room for"),
            Self::Stalled => f.write_str("it did not go on"),
        }
    }
}

impl core::error::Error for Broken {}

impl<const ROOM: usize> Default for Receiver<ROOM> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const ROOM: usize> Receiver<ROOM> {
    /// Nothing received yet.
    pub const fn new() -> Self {
        Self {
            decoder: DecoderState::Idle,
            bytes: Vec::new(),
            progress: Progress::Waiting,
        }
    }

    /// Takes a byte; says what came to its end with it: a message, or something broken.
    ///
    /// While there is a message, nothing else is received.
    pub fn receive(&mut self, byte: u8) -> Option<Result<(), Broken>> {
        if self.progress == Progress::Received {
            return None;
        }
        match self.decoder.feed(byte) {
            Ok(DecodeResult::NoData) => None,
            Ok(DecodeResult::DataStart) => {
                self.bytes.clear();
                self.progress = Progress::Receiving;
                None
            }
            Ok(DecodeResult::DataContinue(byte)) => {
                if self.bytes.push(byte).is_err() {
                    self.progress = Progress::TooLong;
                }
                None
            }
            Ok(DecodeResult::DataComplete) => Some(self.end()),
            Err(_) => Some(Err(self.broken(Broken::Damaged))),
        }
    }

    /// The message, if there is one.
    pub fn message(&self) -> Option<Message<'_>> {
        let is_there = self.progress == Progress::Received;
        self.parts()
            .filter(|_| is_there)
            .map(|(message, _)| message)
    }

    /// Forgets what there is: a message; or a part of one, and then says so.
    pub fn forget(&mut self) -> Option<Broken> {
        let is_part = matches!(self.progress, Progress::Receiving | Progress::TooLong);
        self.decoder = DecoderState::Idle;
        let broken = self.broken(Broken::Stalled);
        is_part.then_some(broken)
    }

    fn end(&mut self) -> Result<(), Broken> {
        let is_right = self.parts().is_some_and(|(message, sum)| {
            checksum(&[&message.ticket.to_le_bytes(), message.scene]) == sum
        });
        if is_right && self.progress == Progress::Receiving {
            self.progress = Progress::Received;
            Ok(())
        } else {
            Err(self.broken(Broken::Damaged))
        }
    }

    /// Forgets what was received, and says why.
    fn broken(&mut self, why: Broken) -> Broken {
        let was_too_long = self.progress == Progress::TooLong;
        self.bytes.clear();
        self.progress = Progress::Waiting;
        match was_too_long {
            true => Broken::TooLong {
                most: ROOM.saturating_sub(crate::frame::EXTRA),
            },
            false => why,
        }
    }

    /// A message and its checksum, right or wrong.
    fn parts(&self) -> Option<(Message<'_>, u32)> {
        let (ticket, rest) = self.bytes.split_first_chunk()?;
        let (scene, checksum) = rest.split_last_chunk()?;
        let ticket = u16::from_le_bytes(*ticket);
        Some((Message { ticket, scene }, u32::from_le_bytes(*checksum)))
    }
}
