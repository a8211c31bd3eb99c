use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use embedded_graphics::geometry::Size;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

use super::difference::{changed_area, crop};
use super::film::{Film, unwritable};
use super::schedule::Schedule;
use crate::outcome::Outcome;

/// Unit of frame delays: 1/1000 s.
const UNITS_PER_SECOND: u16 = 1000;

/// Writes an animated PNG with 24-bit colors. The first frame is stored whole. Each later frame
/// stores only the area that differs from the previous frame.
struct Apng {
    path: PathBuf,
    writer: png::Writer<BufWriter<File>>,
    delays: Vec<u16>,
    size: Size,
    previous: Option<Vec<u8>>,
    count: usize,
}

pub(super) fn film(path: &Path, size: Size, schedule: &Schedule) -> Outcome<Box<dyn Film>> {
    let frames = schedule.times.len();
    let open = || -> Result<_, png::EncodingError> {
        let file = BufWriter::new(File::create(path)?);
        let mut encoder = png::Encoder::new(file, size.width, size.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        // In APNG, 0 plays means that the animation repeats without end.
        encoder.set_animated(frames as u32, u32::from(!schedule.looping))?;
        encoder.write_header()
    };
    Ok(Box::new(Apng {
        path: path.to_owned(),
        writer: open().map_err(|error| unwritable(path, error))?,
        delays: (0..frames)
            .map(|frame| schedule.delay(frame, UNITS_PER_SECOND.into()))
            .collect(),
        size,
        previous: None,
        count: 0,
    }))
}

impl Apng {
    fn write(&mut self, pixels: &[u8]) -> Result<(), png::EncodingError> {
        let width = self.size.width;
        // The first frame is the whole picture.
        let area = match &self.previous {
            Some(previous) => changed_area::<3>(previous, pixels, width),
            None => Rectangle::new(Point::zero(), self.size),
        };
        let delay = self.delays.get(self.count).copied().unwrap_or_default();
        self.writer.set_frame_delay(delay, UNITS_PER_SECOND)?;
        self.writer.reset_frame_position()?;
        self.writer
            .set_frame_dimension(area.size.width, area.size.height)?;
        self.writer
            .set_frame_position(area.top_left.x as u32, area.top_left.y as u32)?;
        self.writer
            .write_image_data(&crop::<3>(pixels, width, &area))
    }
}

impl Film for Apng {
    fn add(&mut self, pixels: &[u8]) -> Outcome {
        self.write(pixels)
            .map_err(|error| unwritable(&self.path, error))?;
        self.previous = Some(pixels.to_vec());
        self.count += 1;
        Ok(())
    }

    fn finish(self: Box<Self>) -> Outcome {
        let written = self.writer.finish();
        Ok(written.map_err(|error| unwritable(&self.path, error))?)
    }
}
