//! Display that accepts whole lines only.

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

/// Display of 40x30 pixels that records lines, and can fail at a chosen call and
/// pixel. Panics on single pixels.
#[derive(Default)]
pub(crate) struct LineDisplay {
    pub(crate) lines: Vec<(Rectangle, Vec<Rgb888>)>,
    /// Index of the call that fails, and the number of pixels it takes before.
    pub(crate) fails_at: Option<(usize, usize)>,
}

/// Error of a display that fails.
#[derive(Debug, PartialEq)]
pub(crate) struct Unplugged;

impl OriginDimensions for LineDisplay {
    fn size(&self) -> Size {
        Size::new(40, 30)
    }
}

impl DrawTarget for LineDisplay {
    type Color = Rgb888;
    type Error = Unplugged;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, _: I) -> Result<(), Unplugged> {
        panic!("the renderer drew single pixels")
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb888>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Unplugged> {
        if let Some((call, pixels)) = self.fails_at
            && call == self.lines.len()
        {
            colors.into_iter().take(pixels).for_each(drop);
            return Err(Unplugged);
        }
        self.lines.push((*area, colors.into_iter().collect()));
        Ok(())
    }
}
