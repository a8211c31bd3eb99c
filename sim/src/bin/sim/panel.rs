//! A draw target whose color format is chosen at run time.
//!
//! The renderer is generic over the color type of the draw target. This draw target has one color
//! type for all formats, so the renderer is compiled only once. The color type stores the radiance,
//! which the draw target converts to the chosen format.

use std::convert::Infallible;

use embedded_graphics::pixelcolor::{
    BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use whitted::render::Output;
use whitted::{Color, Radiance};

use crate::format::Format;

/// Simulated display with a color format that is chosen at run time.
pub(crate) struct Panel {
    pub(crate) display: SimulatorDisplay<Rgb888>,
    pub(crate) format: Format,
}

/// Radiance of a pixel. It is converted to the display's color format later.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct DeferredColor {
    color: Color<Radiance>,
    at: Point,
    output: Output,
}

impl PixelColor for DeferredColor {
    type Raw = ();
}

impl whitted::render::DisplayColor for DeferredColor {
    #[inline]
    fn from_radiance(color: Color<Radiance>, at: Point, output: Output) -> Self {
        Self { color, at, output }
    }
}

impl DeferredColor {
    /// Converts the radiance to a display's color format, and the result to a 24-bit color for the
    /// host.
    fn convert(self, format: Format) -> Rgb888 {
        match format {
            Format::Rgb888 => self.convert_as::<Rgb888>(),
            Format::Rgb666 => self.convert_as::<Rgb666>(),
            Format::Rgb565 => self.convert_as::<Rgb565>(),
            Format::Rgb555 => self.convert_as::<Rgb555>(),
            Format::Gray8 => self.convert_as::<Gray8>(),
            Format::Gray4 => self.convert_as::<Gray4>(),
            Format::Gray2 => self.convert_as::<Gray2>(),
            Format::Binary => self.convert_as::<BinaryColor>(),
        }
    }

    fn convert_as<C: whitted::render::DisplayColor + Into<Rgb888>>(self) -> Rgb888 {
        C::from_radiance(self.color, self.at, self.output).into()
    }
}

impl Panel {
    /// Creates a black display.
    pub(crate) fn new(size: Size, format: Format) -> Self {
        Self {
            display: SimulatorDisplay::new(size),
            format,
        }
    }
}

impl OriginDimensions for Panel {
    fn size(&self) -> Size {
        self.display.size()
    }
}

impl DrawTarget for Panel {
    type Color = DeferredColor;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Pixel<DeferredColor>>,
    {
        let Self { display, format } = self;
        let pixels = pixels.into_iter();
        display.draw_iter(pixels.map(|Pixel(at, color)| Pixel(at, color.convert(*format))))
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = DeferredColor>,
    {
        let Self { display, format } = self;
        let colors = colors.into_iter();
        display.fill_contiguous(area, colors.map(|color| color.convert(*format)))
    }
}
