//! Pictures in memory.

use whitted::Color;

/// A picture with 16 bits per channel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// The `width * height` pixels of the picture, row by row from the top. The largest value of a
    /// sample is 65535.
    pub pixels: Vec<Color<u16>>,
}
