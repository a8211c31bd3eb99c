use embedded_graphics_core::geometry::Point;
use whitted::codec::Crc32;
use whitted::render::{DisplayColor, Output};
use whitted::{Color, Renderer};

/// CRC-32 of a frame's 16-bit linear samples, row by row: traced line by line,
/// so that other work can be done in between.
#[derive(Default)]
pub struct Checksum {
    crc: Crc32,
    y: u32,
}

impl Checksum {
    /// Traces the next line; the checksum, if that was the last.
    pub fn line(&mut self, renderer: &mut Renderer<'_>) -> Option<u32> {
        for pixel in renderer.line(self.y) {
            self.crc.update_pixel(Color::<u16>::from_radiance(
                pixel,
                Point::zero(),
                Output::default(),
            ));
        }
        self.y += 1;
        (self.y == renderer.size().height).then(|| self.crc.finish())
    }
}
