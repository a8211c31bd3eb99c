//! Transfer functions and dithering, which convert linear radiance to the levels of a display.

mod dither;
mod transfer;

pub use dither::Dither;
pub use transfer::Transfer;

/// Conversion of linear radiance to the levels of a display.
///
/// The default output is linear, and channels of fewer than 8 bits are dithered.
///
/// ```
/// use whitted::render::{Output, Transfer};
///
/// let output = Output { transfer: Transfer::Srgb, ..Output::default() };
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Output {
    /// Transfer function from linear radiance to display values.
    pub transfer: Transfer,
    /// Dithering of values that lie between two levels of a display channel.
    pub dither: Dither,
}
