//! Parsers of option values.

use embedded_graphics::geometry::Size;
use whitted::Real;

/// Largest width and height of a picture. Larger pictures would take more than 0.5 GB of memory, and
/// more than the antialiasing renderer supports.
const MAX_SIDE: u32 = 4096;

/// Parses `WIDTHxHEIGHT`.
pub(super) fn size(text: &str) -> Result<Size, String> {
    let sides = text.split_once('x').map(|(w, h)| (w.parse(), h.parse()));
    let Some((Ok(width), Ok(height))) = sides else {
        return Err("write width and height, for example 320x240".to_owned());
    };
    let range = 1..=MAX_SIDE;
    if range.contains(&width) && range.contains(&height) {
        Ok(Size::new(width, height))
    } else {
        Err(format!("width and height must be from 1 to {MAX_SIDE}"))
    }
}

/// Parses a decimal number.
pub(super) fn real(text: &str) -> Result<Real, String> {
    text.parse()
        .map_err(|_| "write a number, for example 0.004".to_owned())
}
