use core::convert::Infallible;
use core::hint::black_box;

use embedded_graphics_core::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};

/// Display that discards all pixels, at the lowest possible cost.
pub struct NullDisplay(Size);

impl NullDisplay {
    /// Creates a display of the given size.
    pub fn new(size: Size) -> Self {
        Self(size)
    }
}

impl OriginDimensions for NullDisplay {
    fn size(&self) -> Size {
        self.0
    }
}

impl DrawTarget for NullDisplay {
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
        // Every color must be used: otherwise the optimizer removes the rendering.
        let combined = colors
            .into_iter()
            .fold(0, |combined, color| combined ^ color.into_storage());
        black_box(combined);
        Ok(())
    }
}
