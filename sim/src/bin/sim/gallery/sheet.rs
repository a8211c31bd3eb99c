use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::{OutputImage, OutputSettings, SimulatorDisplay};
use whitted::render::Transfer;

use super::thumbnail::thumbnail;
use crate::outcome::Outcome;

/// File name of the contact sheet.
pub(super) const FILE: &str = "contact-sheet.png";

const COLUMNS: u32 = 6;
/// Largest size of a thumbnail.
const MAX_THUMBNAIL: Size = Size::new(128, 96);
const MARGIN: u32 = 8;
const BACKGROUND: Rgb888 = Rgb888::new(32, 32, 32);

/// A contact sheet, which shows thumbnails in rows. All pictures must have the same size.
pub(super) struct Sheet {
    display: SimulatorDisplay<Rgb888>,
    thumbnail: Size,
    columns: u32,
    count: u32,
}

impl Sheet {
    /// Creates a contact sheet for a number of pictures.
    pub(super) fn new(pictures: usize, size: Size) -> Self {
        let pictures = pictures as u32;
        let columns = pictures.clamp(1, COLUMNS);
        let thumbnail = thumbnail_size(size);
        let cells = Size::new(columns, pictures.div_ceil(columns));
        let margin = Size::new_equal(MARGIN);
        let whole = cells.component_mul(thumbnail + margin) + margin;
        Self {
            display: SimulatorDisplay::with_default_color(whole, BACKGROUND),
            thumbnail,
            columns,
            count: 0,
        }
    }

    /// Adds the thumbnail of the next picture to the sheet. `transfer` is the encoding of the
    /// picture.
    pub(super) fn add(&mut self, image: &OutputImage<Rgb888>, transfer: Transfer) -> Outcome {
        let cell = Size::new(self.count % self.columns, self.count / self.columns);
        let margin = Size::new_equal(MARGIN);
        let corner = Point::zero() + cell.component_mul(self.thumbnail + margin) + margin;
        let area = Rectangle::new(corner, self.thumbnail);
        self.count += 1;
        let pixels = thumbnail(image, transfer, self.thumbnail);
        Ok(self.display.fill_contiguous(&area, pixels)?)
    }

    /// Returns the contact sheet as a picture.
    pub(super) fn image(&self) -> OutputImage<Rgb888> {
        self.display.to_rgb_output_image(&OutputSettings::default())
    }
}

/// Returns the size of the largest thumbnail that fits in [`MAX_THUMBNAIL`] and has the aspect
/// ratio of the picture.
fn thumbnail_size(picture: Size) -> Size {
    let Size { width, height } = picture;
    let scaled = |side: u32, to: u32, from: u32| (side * to / from).max(1);
    if width * MAX_THUMBNAIL.height > height * MAX_THUMBNAIL.width {
        Size::new(
            MAX_THUMBNAIL.width,
            scaled(height, MAX_THUMBNAIL.width, width),
        )
    } else {
        Size::new(
            scaled(width, MAX_THUMBNAIL.height, height),
            MAX_THUMBNAIL.height,
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thumbnails_keep_the_aspect_ratio() {
        assert_eq!(thumbnail_size(Size::new(320, 240)), MAX_THUMBNAIL);
        assert_eq!(thumbnail_size(Size::new(128, 64)), Size::new(128, 64));
        assert_eq!(thumbnail_size(Size::new(100, 200)), Size::new(48, 96));
        assert_eq!(thumbnail_size(Size::new(8192, 1)), Size::new(128, 1));
    }
}
