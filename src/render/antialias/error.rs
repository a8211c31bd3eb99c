use core::fmt;

use super::pattern::MAX_SIDE;

/// Why a picture cannot be drawn with smooth edges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AntialiasError {
    /// The memory is shorter than two lines.
    TooLittleMemory {
        /// What two lines take.
        samples: usize,
    },
    /// A side of the picture is longer than 8191 pixels.
    TooLarge,
}

impl fmt::Display for AntialiasError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLittleMemory { samples } => {
                write!(f, "the memory is too small: give it {samples} samples")
            }
            Self::TooLarge => write!(f, "the picture is too large: at most {MAX_SIDE} a side"),
        }
    }
}

impl core::error::Error for AntialiasError {}
