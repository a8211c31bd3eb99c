use core::fmt;

use super::pattern::MAX_SIDE;

/// Reason why an [`AntialiasedRenderer`](super::AntialiasedRenderer) cannot be created.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AntialiasError {
    /// The memory has too few samples. Each pixel of two lines needs one sample.
    TooLittleMemory {
        /// Number of samples that two lines of the picture need.
        samples: usize,
    },
    /// A side of the picture is longer than 8191 pixels.
    TooLarge,
}

impl fmt::Display for AntialiasError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLittleMemory { samples } => {
                write!(f, "the memory is too small: provide {samples} samples")
            }
            Self::TooLarge => write!(
                f,
                "the picture is too large: at most {MAX_SIDE} pixels per side"
            ),
        }
    }
}

impl core::error::Error for AntialiasError {}
