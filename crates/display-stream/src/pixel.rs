//! Pixels of 16 bits as a panel shows them.

use embedded_graphics_core::pixelcolor::raw::RawU16;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};

/// MADCTL's bit for panels with blue first.
const BGR: u8 = 0x08;

/// Whether red and blue change places: this address mode does not fit the panel.
pub(crate) fn is_swapped(madctl: u8, upright: u8) -> bool {
    (madctl ^ upright) & BGR != 0
}

/// The color of a pixel in the memory.
pub(crate) fn shown(pixel: u16, is_swapped: bool, is_negative: bool) -> Rgb565 {
    let color = Rgb565::from(RawU16::new(if is_negative { !pixel } else { pixel }));
    if is_swapped {
        Rgb565::new(color.b(), color.g(), color.r())
    } else {
        color
    }
}
