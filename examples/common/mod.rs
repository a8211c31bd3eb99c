//! A display in memory. The examples draw on this display and save its pixels as a PNG file.
//!
//! In firmware, use the driver of your display instead. Like this display, drivers implement
//! `DrawTarget`.

#![allow(dead_code, reason = "each example uses a part of this module")]

pub(crate) mod scene;

use std::convert::Infallible;
use std::error::Error;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

/// Width of the gap between two pictures in a PNG file, in pixels.
const GAP: u32 = 8;

/// A display with 16-bit pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Display {
    pub(crate) size: Size,
    /// Pixels in rows from top to bottom.
    pub(crate) pixels: Vec<Rgb565>,
}

impl Display {
    /// Returns a black display.
    pub(crate) fn new(size: Size) -> Self {
        let pixels = vec![Rgb565::BLACK; (size.width * size.height) as usize];
        Self { size, pixels }
    }

    /// Shows one line of pixels. A driver would send the line over an SPI bus.
    pub(crate) fn show_line(&mut self, y: u32, line: &[Rgb565]) {
        let area = Rectangle::new(Point::new(0, y as i32), Size::new(self.size.width, 1));
        let Ok(()) = self.fill_contiguous(&area, line.iter().copied());
    }

    /// Returns the index of a pixel, or `None` if the point is outside the display.
    fn index(&self, point: Point) -> Option<usize> {
        let (x, y) = (u32::try_from(point.x).ok()?, u32::try_from(point.y).ok()?);
        let is_inside = x < self.size.width && y < self.size.height;
        is_inside.then_some((y * self.size.width + x) as usize)
    }
}

impl OriginDimensions for Display {
    fn size(&self) -> Size {
        self.size
    }
}

impl DrawTarget for Display {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        for Pixel(point, color) in pixels {
            if let Some(index) = self.index(point) {
                self.pixels[index] = color;
            }
        }
        Ok(())
    }
}

/// Saves the pictures on displays side by side in a PNG file. Each display pixel becomes a
/// square of `scale` by `scale` pixels.
///
/// If the command line gives a path, the file is written there. Otherwise, it is written to
/// the current directory under the name `name`.
pub(crate) fn save(name: &str, scale: u32, displays: &[Display]) -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).unwrap_or_else(|| name.to_owned());
    write_png(path.as_ref(), scale, displays)?;
    println!("wrote {path}");
    Ok(())
}

/// Writes a PNG file that shows displays side by side. All displays must have the same size.
pub(crate) fn write_png(
    path: &Path,
    scale: u32,
    displays: &[Display],
) -> Result<(), Box<dyn Error>> {
    let (size, bytes) = side_by_side(displays, scale);
    let file = BufWriter::new(File::create(path)?);
    let mut encoder = png::Encoder::new(file, size.width, size.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.write_header()?.write_image_data(&bytes)?;
    Ok(())
}

/// Places displays side by side on a white image. Returns the size of the image and its
/// pixels. Each pixel has 3 bytes.
fn side_by_side(displays: &[Display], scale: u32) -> (Size, Vec<u8>) {
    let Size { width, height } = displays.first().map_or(Size::zero(), |first| first.size);
    let pitch = width * scale + GAP;
    let size = Size::new(
        (pitch * displays.len() as u32).saturating_sub(GAP),
        height * scale,
    );
    let mut bytes = Vec::new();
    for point in Rectangle::new(Point::zero(), size).points() {
        let (x, y) = (point.x as u32, point.y as u32);
        let in_display = Point::new((x % pitch / scale) as i32, (y / scale) as i32);
        let display = &displays[(x / pitch) as usize];
        let color = display
            .index(in_display)
            .map_or(Rgb888::WHITE, |index| display.pixels[index].into());
        bytes.extend([color.r(), color.g(), color.b()]);
    }
    (size, bytes)
}
