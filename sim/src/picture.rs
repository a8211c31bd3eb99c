//! Pictures in memory.

use whitted::Color;

/// A picture with 16 bits per channel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// Pixels of the picture (`width * height`), row by row from the top. The largest sample is
    /// 65535.
    pub pixels: Vec<Color<u16>>,
}
