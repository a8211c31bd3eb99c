use core::convert::Infallible;

use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{OriginDimensions, Point, Size};
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};

/// Picture on a display, stored line by line from the top left.
///
/// A picture is also a [`DrawTarget`]. A test can therefore run the same drawing code on a
/// picture and on a display, and compare the results.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    size: Size,
    pixels: Vec<Rgb565>,
}

impl Picture {
    /// Creates a black picture.
    pub fn new(size: Size) -> Self {
        Self::from_fn(size, |_| Rgb565::BLACK)
    }

    /// Creates a picture from the function `color`, which returns the color at a point.
    pub(crate) fn from_fn(size: Size, color: impl FnMut(Point) -> Rgb565) -> Self {
        let line = |y| (0..size.width).map(move |x| Point::new(x as i32, y as i32));
        Self {
            size,
            pixels: (0..size.height).flat_map(line).map(color).collect(),
        }
    }

    /// Returns the pixels, line by line.
    pub fn pixels(&self) -> &[Rgb565] {
        &self.pixels
    }

    /// Returns the pixel at `at`, or `None` if `at` is outside the picture.
    pub fn pixel(&self, at: Point) -> Option<Rgb565> {
        self.pixels.get(self.index(at)?).copied()
    }

    /// Returns the position of the first pixel that differs between this picture and
    /// `other`. The two pictures must have the same size.
    pub fn first_difference(&self, other: &Self) -> Option<Point> {
        let mut pairs = self.pixels.iter().zip(&other.pixels);
        let index = pairs.position(|(own, other)| own != other)? as u32;
        let width = self.size.width.max(1);
        Some(Point::new((index % width) as i32, (index / width) as i32))
    }

    fn index(&self, at: Point) -> Option<usize> {
        let (x, y) = (u32::try_from(at.x).ok()?, u32::try_from(at.y).ok()?);
        let is_inside = x < self.size.width && y < self.size.height;
        is_inside.then(|| (y * self.size.width + x) as usize)
    }
}

impl OriginDimensions for Picture {
    fn size(&self) -> Size {
        self.size
    }
}

impl DrawTarget for Picture {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        for Pixel(at, color) in pixels {
            if let Some(pixel) = self.index(at).and_then(|index| self.pixels.get_mut(index)) {
                *pixel = color;
            }
        }
        Ok(())
    }
}
