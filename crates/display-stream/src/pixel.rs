//! Conversion of 16-bit pixels in memory to visible colors.

use embedded_graphics_core::pixelcolor::raw::RawU16;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};

/// MADCTL bit for BGR color order.
const BGR: u8 = 0x08;

/// Returns true if red and blue appear swapped. They do if the color order in `madctl`
/// differs from the color order of the panel.
pub(crate) fn is_red_blue_swapped(madctl: u8, panel_madctl: u8) -> bool {
    (madctl ^ panel_madctl) & BGR != 0
}

/// Returns the visible color of a pixel in memory.
pub(crate) fn visible_color(pixel: u16, is_swapped: bool, is_negative: bool) -> Rgb565 {
    let color = Rgb565::from(RawU16::new(if is_negative { !pixel } else { pixel }));
    if is_swapped {
        Rgb565::new(color.b(), color.g(), color.r())
    } else {
        color
    }
}
