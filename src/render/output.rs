//! How linear light is shown in the levels of a display.

mod dither;
mod transfer;

pub use dither::Dither;
pub use transfer::Transfer;

/// How a picture is shown on a display.
///
/// The default shows linear values as they are, and dithers where levels are few.
///
/// ```
/// use whitted::render::{Output, Transfer};
///
/// let output = Output { transfer: Transfer::Srgb, ..Output::default() };
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Output {
    /// From linear light to the values of the display.
    pub transfer: Transfer,
    /// What becomes of values between two levels.
    pub dither: Dither,
}
