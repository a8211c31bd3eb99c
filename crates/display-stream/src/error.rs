use core::error::Error;
use core::fmt;

use embedded_graphics_core::geometry::{Point, Size};

/// What a driver should not have sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StreamError {
    /// Data that no command came before.
    NoCommand {
        /// The data.
        data: u8,
    },
    /// A command that changes the picture in a way that is not modeled.
    NotModeled {
        /// The command.
        command: u8,
    },
    /// A command that came before the parameters of the one before were complete.
    Interrupted {
        /// The command that lacks parameters.
        command: u8,
        /// How many it has got.
        received: usize,
        /// How many it takes.
        expected: usize,
    },
    /// A range of addresses whose end is before its start.
    Reversed {
        /// The command that set it.
        command: u8,
        /// Its first column or row.
        first: u16,
        /// Its last.
        last: u16,
    },
    /// Pixels for a window that reaches out of the memory.
    OutsideOfMemory {
        /// The last column and row of the window.
        last: Point,
        /// How many columns and rows there are, in this orientation.
        memory: Size,
    },
    /// Pixels while pixels do not have 16 bits.
    PixelFormat {
        /// The parameter of COLMOD.
        colmod: u8,
    },
    /// More pixels without a start in this window, after which they could go on.
    NothingToContinue,
}

impl fmt::Display for StreamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoCommand { data } => {
                write!(
                    f,
                    "data 0x{data:02X} before any command: look at the D/C pin"
                )
            }
            Self::NotModeled { command } => {
                write!(f, "command 0x{command:02X}, which is not modeled")
            }
            Self::Interrupted {
                command,
                received,
                expected,
            } => write!(
                f,
                "command 0x{command:02X} has {received} of its {expected} parameters"
            ),
            Self::Reversed {
                command,
                first,
                last,
            } => write!(
                f,
                "command 0x{command:02X} ends at {last}, before its start {first}"
            ),
            Self::OutsideOfMemory { last, memory } => write!(
                f,
                "pixels up to column {}, row {} of a memory of {} columns, {} rows: set window or orientation right",
                last.x, last.y, memory.width, memory.height
            ),
            Self::PixelFormat { colmod } => write!(
                f,
                "pixels while COLMOD is 0x{colmod:02X}, which is not 16 bits a pixel (0x55)"
            ),
            Self::NothingToContinue => {
                write!(
                    f,
                    "RAMWRC (0x3C) where no RAMWR (0x2C) has started: send that first"
                )
            }
        }
    }
}

impl Error for StreamError {}

/// Why a display shows no picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BlankError {
    /// It sleeps.
    Asleep,
    /// It is off.
    Off,
    /// A pixel was never written, so it shows what the memory had at power-on.
    NeverWritten {
        /// The first such pixel, as a person sees it.
        at: Point,
    },
}

impl fmt::Display for BlankError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Asleep => write!(f, "the display sleeps: send SLPOUT (0x11)"),
            Self::Off => write!(f, "the display is off: send DISPON (0x29)"),
            Self::NeverWritten { at } => write!(
                f,
                "the pixel at ({}, {}) was never written: clear the display or draw all of it",
                at.x, at.y
            ),
        }
    }
}

impl Error for BlankError {}
