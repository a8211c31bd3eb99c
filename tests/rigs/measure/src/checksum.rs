use embedded_graphics_core::geometry::Point;
use whitted::codec::Crc32;
use whitted::render::{DisplayColor, Output};
use whitted::{Color, Renderer};

/// CRC-32 of the 16-bit linear samples of a frame, row by row.
///
/// The frame is traced line by line, so the caller can poll inputs between lines.
#[derive(Default)]
pub struct Checksum {
    crc: Crc32,
    y: u32,
}

impl Checksum {
    /// Traces the next line. Returns the checksum after the last line.
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
