use core::error::Error;
use core::fmt;

use embedded_graphics_core::geometry::{Point, Size};

/// Error in the SPI traffic, caused by bytes that a correct driver does not send.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum StreamError {
    /// A data byte arrived before any command.
    NoCommand {
        /// The data byte.
        data: u8,
    },
    /// The model does not implement the received command.
    NotModeled {
        /// The opcode.
        command: u8,
    },
    /// A command arrived before all parameters of the previous command had arrived.
    Interrupted {
        /// Opcode of the command that lacks parameters.
        command: u8,
        /// Number of parameter bytes received.
        received: usize,
        /// Number of parameter bytes that the command takes.
        expected: usize,
    },
    /// A command selected a window whose last column or row is before the first column or
    /// row.
    Reversed {
        /// Opcode of the command: CASET or RASET.
        command: u8,
        /// First column or row.
        first: u16,
        /// Last column or row.
        last: u16,
    },
    /// A pixel was sent, but the window extends beyond the memory.
    OutsideOfMemory {
        /// Last column and row of the window.
        last: Point,
        /// Columns and rows of the memory in the current orientation.
        memory: Size,
    },
    /// A pixel was sent, but the COLMOD register does not select 16 bits per pixel.
    PixelFormat {
        /// Current value of COLMOD.
        colmod: u8,
    },
    /// RAMWRC arrived without a RAMWR in the current window.
    NothingToContinue,
}

impl fmt::Display for StreamError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NoCommand { data } => {
                write!(f, "data 0x{data:02X} before any command: check the D/C pin")
            }
            Self::NotModeled { command } => {
                write!(f, "command 0x{command:02X} is not supported by this model")
            }
            Self::Interrupted {
                command,
                received,
                expected,
            } => write!(
                f,
                "command 0x{command:02X} has {received} of {expected} parameters"
            ),
            Self::Reversed {
                command,
                first,
                last,
            } => write!(
                f,
                "command 0x{command:02X}: last address {last} is before first address {first}"
            ),
            Self::OutsideOfMemory { last, memory } => write!(
                f,
                "window ends at column {}, row {}, outside the memory of {} columns, {} rows: check window and orientation",
                last.x, last.y, memory.width, memory.height
            ),
            Self::PixelFormat { colmod } => write!(
                f,
                "pixel data while COLMOD is 0x{colmod:02X}: set 16 bits per pixel (0x55) first"
            ),
            Self::NothingToContinue => {
                write!(
                    f,
                    "RAMWRC (0x3C) without RAMWR (0x2C) in this window: send RAMWR first"
                )
            }
        }
    }
}

impl Error for StreamError {}

/// The reason why a display shows no picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BlankError {
    /// The controller is in sleep mode.
    Asleep,
    /// The display is switched off.
    Off,
    /// A visible pixel was never written, so its color is undefined.
    NeverWritten {
        /// Screen position of the first such pixel.
        at: Point,
    },
}

impl fmt::Display for BlankError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Asleep => write!(f, "the display is in sleep mode: send SLPOUT (0x11)"),
            Self::Off => write!(f, "the display is off: send DISPON (0x29)"),
            Self::NeverWritten { at } => write!(
                f,
                "the pixel at ({}, {}) was never written: clear the display first",
                at.x, at.y
            ),
        }
    }
}

impl Error for BlankError {}
