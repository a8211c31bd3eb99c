//! Screenshots of a window.

use std::path::{Path, PathBuf};

use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::iso_8859_1::FONT_6X13;
use embedded_graphics::pixelcolor::{BinaryColor, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Baseline, Text};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use whitted::Color;
use whitted_sim::picture::Picture;
use whitted_sim::png16;

use crate::outcome::Outcome;

/// Width and height of the area above the status text.
const PICTURE_AREA: [usize; 2] = [640, 480];

/// 24-bit color.
type Rgb = [u8; 3];

/// Pixels of a window or a picture.
#[derive(PartialEq)]
pub(crate) struct Shot {
    width: usize,
    pixels: Vec<Rgb>,
}

impl Shot {
    /// Converts pixels in X's format: blue, green, red, unused.
    pub(crate) fn new(width: usize, bytes: &[u8]) -> Self {
        let (pixels, _) = bytes.as_chunks::<4>();
        let pixels = pixels.iter().map(|[b, g, r, _]| [*r, *g, *b]).collect();
        Self { width, pixels }
    }

    /// Reads a PNG with 8 bits per channel.
    pub(crate) fn read(path: &Path) -> Outcome<Self> {
        let Picture { width, pixels, .. } = png16::read(path)?;
        let rgb =
            |color: Color<u16>| [color.r, color.g, color.b].map(|channel| (channel >> 8) as u8);
        let pixels = pixels.into_iter().map(rgb).collect();
        let width = width as usize;
        Ok(Self { width, pixels })
    }

    /// Writes a PNG for inspection and returns its path.
    pub(crate) fn save(&self, name: &str) -> Outcome<PathBuf> {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join(name)
            .with_extension("png");
        let size = Size::new(self.width as u32, self.height() as u32);
        let mut display = SimulatorDisplay::<Rgb888>::new(size);
        let pixels = self.pixels.iter().map(|[r, g, b]| Rgb888::new(*r, *g, *b));
        let Ok(()) = display.fill_contiguous(&display.bounding_box(), pixels);
        let image = display.to_rgb_output_image(&OutputSettings::default());
        image.save_png(&path)?;
        Ok(path)
    }

    fn height(&self) -> usize {
        self.pixels.len() / self.width
    }

    fn row(&self, y: usize, x: usize, width: usize) -> &[Rgb] {
        &self.pixels[y * self.width + x..][..width]
    }

    /// Returns true if the picture is centered in the area above the status text.
    pub(crate) fn shows(&self, picture: &Self) -> bool {
        let (width, height) = (picture.width, picture.height());
        let (left, top) = (
            (PICTURE_AREA[0] - width) / 2,
            (PICTURE_AREA[1] - height) / 2,
        );
        (0..height).all(|y| self.row(top + y, left, width) == picture.row(y, 0, width))
    }

    /// Returns true if the status text has a line with this text and color.
    pub(crate) fn says(&self, text: &str, color: Rgb) -> bool {
        let mask = Mask::of(text);
        let is_at = |x: usize, y: usize| {
            let mut rows = mask.lit.chunks(mask.width).zip(y..);
            rows.all(|(lit, y)| {
                let row = self.row(y, x, mask.width).iter();
                row.zip(lit).all(|(pixel, lit)| (*pixel == color) == *lit)
            })
        };
        let (right, bottom) = (
            self.width.saturating_sub(mask.width),
            self.height() - mask.lit.len() / mask.width,
        );
        (PICTURE_AREA[1]..bottom).any(|y| (0..right).any(|x| is_at(x, y)))
    }
}

/// Pixels that a line of text covers.
struct Mask {
    width: usize,
    lit: Vec<bool>,
}

impl Mask {
    fn of(text: &str) -> Self {
        let style = MonoTextStyle::new(&FONT_6X13, BinaryColor::On);
        let text = Text::with_baseline(text, Point::zero(), style, Baseline::Top);
        let area = text.bounding_box();
        let mut display = SimulatorDisplay::<BinaryColor>::new(area.size);
        let Ok(_) = text.draw(&mut display);
        let lit = |point| display.get_pixel(point).is_on();
        Self {
            width: area.size.width as usize,
            lit: area.points().map(lit).collect(),
        }
    }
}
