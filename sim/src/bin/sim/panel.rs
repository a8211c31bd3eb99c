//! A display of whichever format, for which the ray tracer is compiled once.

use std::convert::Infallible;

use embedded_graphics::pixelcolor::{
    BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use whitted::render::Output;
use whitted::{Color, Radiance};

use crate::args::Format;

/// A display that shows colors in its format.
pub(crate) struct Panel {
    pub(crate) display: SimulatorDisplay<Rgb888>,
    pub(crate) format: Format,
}

/// A color on its way to a display.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Light {
    color: Color<Radiance>,
    at: Point,
    output: Output,
}

impl PixelColor for Light {
    type Raw = ();
}

impl whitted::render::DisplayColor for Light {
    #[inline]
    fn from_radiance(color: Color<Radiance>, at: Point, output: Output) -> Self {
        Self { color, at, output }
    }
}

impl Light {
    /// What a display of the format makes of it.
    fn on(self, format: Format) -> Rgb888 {
        match format {
            Format::Rgb888 => self.shown::<Rgb888>(),
            Format::Rgb666 => self.shown::<Rgb666>(),
            Format::Rgb565 => self.shown::<Rgb565>(),
            Format::Rgb555 => self.shown::<Rgb555>(),
            Format::Gray8 => self.shown::<Gray8>(),
            Format::Gray4 => self.shown::<Gray4>(),
            Format::Gray2 => self.shown::<Gray2>(),
            Format::Binary => self.shown::<BinaryColor>(),
        }
    }

    fn shown<C: whitted::render::DisplayColor + Into<Rgb888>>(self) -> Rgb888 {
        C::from_radiance(self.color, self.at, self.output).into()
    }
}

impl Panel {
    /// A dark display.
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
    type Color = Light;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Pixel<Light>>,
    {
        let Self { display, format } = self;
        let pixels = pixels.into_iter();
        display.draw_iter(pixels.map(|Pixel(at, light)| Pixel(at, light.on(*format))))
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Light>,
    {
        let Self { display, format } = self;
        let colors = colors.into_iter();
        display.fill_contiguous(area, colors.map(|light| light.on(*format)))
    }
}
