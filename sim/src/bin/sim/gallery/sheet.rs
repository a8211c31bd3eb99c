use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::{OutputImage, OutputSettings, SimulatorDisplay};

use super::thumbnail::thumbnail;
use crate::outcome::Outcome;

/// What the sheet is called.
pub(super) const FILE: &str = "contact-sheet.png";

const COLUMNS: u32 = 5;
/// What a thumbnail fits in.
const LARGEST: Size = Size::new(160, 120);
const MARGIN: u32 = 8;
const BETWEEN: Rgb888 = Rgb888::new(32, 32, 32);

/// Thumbnails of pictures of one size, in rows.
pub(super) struct Sheet {
    display: SimulatorDisplay<Rgb888>,
    thumbnail: Size,
    columns: u32,
    count: u32,
}

impl Sheet {
    /// A sheet for so many pictures.
    pub(super) fn new(pictures: usize, size: Size) -> Self {
        let pictures = pictures as u32;
        let columns = pictures.clamp(1, COLUMNS);
        let thumbnail = fitted(size);
        let cells = Size::new(columns, pictures.div_ceil(columns));
        let margin = Size::new_equal(MARGIN);
        let whole = cells.component_mul(thumbnail + margin) + margin;
        Self {
            display: SimulatorDisplay::with_default_color(whole, BETWEEN),
            thumbnail,
            columns,
            count: 0,
        }
    }

    /// Adds the next picture.
    pub(super) fn add(&mut self, image: &OutputImage<Rgb888>) -> Outcome {
        let cell = Size::new(self.count % self.columns, self.count / self.columns);
        let margin = Size::new_equal(MARGIN);
        let corner = Point::zero() + cell.component_mul(self.thumbnail + margin) + margin;
        let area = Rectangle::new(corner, self.thumbnail);
        self.count += 1;
        Ok(self
            .display
            .fill_contiguous(&area, thumbnail(image, self.thumbnail))?)
    }

    /// The sheet as a picture.
    pub(super) fn image(&self) -> OutputImage<Rgb888> {
        self.display.to_rgb_output_image(&OutputSettings::default())
    }
}

/// The largest size of a thumbnail with the sides of a picture.
fn fitted(picture: Size) -> Size {
    let Size { width, height } = picture;
    let scaled = |side: u32, to: u32, from: u32| (side * to / from).max(1);
    if width * LARGEST.height > height * LARGEST.width {
        Size::new(LARGEST.width, scaled(height, LARGEST.width, width))
    } else {
        Size::new(scaled(width, LARGEST.height, height), LARGEST.height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thumbnails_keep_their_sides() {
        assert_eq!(fitted(Size::new(320, 240)), LARGEST);
        assert_eq!(fitted(Size::new(128, 64)), Size::new(160, 80));
        assert_eq!(fitted(Size::new(100, 200)), Size::new(60, 120));
        assert_eq!(fitted(Size::new(8192, 1)), Size::new(160, 1));
    }
}
