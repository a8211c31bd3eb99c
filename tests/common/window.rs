//! A display in memory that counts its pixels from any point.

use std::convert::Infallible;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

/// A display with 16-bit pixels. Pixels outside the display are ignored.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Window {
    pub(crate) area: Rectangle,
    /// Colors in rows from top to bottom, or `None` where nothing has been drawn.
    pub(crate) pixels: Vec<Option<Rgb565>>,
}

impl Window {
    pub(crate) fn new(top_left: Point, size: Size) -> Self {
        Self {
            area: Rectangle::new(top_left, size),
            pixels: vec![None; (size.width * size.height) as usize],
        }
    }

    /// Returns the color of a pixel, or `None` if it has not been drawn.
    pub(crate) fn get(&self, at: Point) -> Option<Rgb565> {
        self.pixels[self.index(at)?]
    }

    fn index(&self, at: Point) -> Option<usize> {
        let Point { x, y } = at - self.area.top_left;
        let (x, y) = (u32::try_from(x).ok()?, u32::try_from(y).ok()?);
        let Size { width, height } = self.area.size;
        (x < width && y < height).then_some((y * width + x) as usize)
    }
}

impl Dimensions for Window {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Window {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        for Pixel(at, color) in pixels {
            if let Some(index) = self.index(at) {
                self.pixels[index] = Some(color);
            }
        }
        Ok(())
    }
}
