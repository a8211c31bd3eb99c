use core::convert::Infallible;
use core::hint::black_box;

use embedded_graphics_core::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};

/// A display without pixels: takes them all, at the least cost there is.
pub struct Blind(Size);

impl Blind {
    /// One of this size.
    pub fn new(size: Size) -> Self {
        Self(size)
    }
}

impl OriginDimensions for Blind {
    fn size(&self) -> Size {
        self.0
    }
}

impl DrawTarget for Blind {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        pixels.into_iter().for_each(|pixel| _ = black_box(pixel));
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, _: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Rgb565>,
    {
        // Without a use of every color, the optimizer would not trace them.
        let all = colors
            .into_iter()
            .fold(0, |all, color| all ^ color.into_storage());
        black_box(all);
        Ok(())
    }
}
