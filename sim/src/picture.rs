//! A picture in memory.

use whitted::Color;

/// Pixels of 16 bits a channel, row by row from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Pixels in a row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `width * height` of them; full scale is 65535.
    pub pixels: Vec<Color<u16>>,
}
