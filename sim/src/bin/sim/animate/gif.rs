use std::fs::File;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::Rectangle;
use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use super::difference::{changed_area, crop};
use super::film::{Film, unwritable};
use super::palette::Palette;
use super::schedule::Schedule;
use crate::outcome::Outcome;

/// Unit of frame delays: 1/100 s.
const UNITS_PER_SECOND: u32 = 100;

/// Writes a GIF. All frames stay in memory until the end, because they share one palette.
struct Gif {
    path: PathBuf,
    file: BufWriter<File>,
    size: Size,
    delays: Vec<u16>,
    looping: bool,
    frames: Vec<Vec<u8>>,
}

pub(super) fn film(path: &Path, size: Size, schedule: &Schedule) -> Outcome<Box<dyn Film>> {
    let file = File::create(path).map_err(|error| unwritable(path, error))?;
    let frames = 0..schedule.times.len();
    Ok(Box::new(Gif {
        path: path.to_owned(),
        file: BufWriter::new(file),
        size,
        delays: frames
            .map(|frame| schedule.delay(frame, UNITS_PER_SECOND))
            .collect(),
        looping: schedule.looping,
        frames: Vec::new(),
    }))
}

impl Film for Gif {
    fn add(&mut self, pixels: &[u8]) -> Outcome {
        self.frames.push(pixels.to_vec());
        Ok(())
    }

    fn finish(self: Box<Self>) -> Outcome {
        let path = self.path.clone();
        Ok(self.write().map_err(|error| unwritable(&path, error))?)
    }
}

impl Gif {
    fn write(self) -> Result<(), EncodingError> {
        // The width and the height fit in 16 bits, because the command line limits them to 8192
        // pixels.
        let [width, height] = [self.size.width, self.size.height].map(|side| side as u16);
        let mut palette = Palette::new(&self.frames);
        let mut encoder = Encoder::new(self.file, width, height, &palette.colors())?;
        if self.looping {
            encoder.set_repeat(Repeat::Infinite)?;
        }
        let transparent = palette.transparent();
        let mut previous = None;
        for (pixels, delay) in self.frames.iter().zip(self.delays) {
            let indices = palette.indices(pixels);
            let (area, buffer) = difference(previous.as_deref(), &indices, self.size, transparent);
            encoder.write_frame(&Frame {
                delay,
                dispose: DisposalMethod::Keep,
                transparent: Some(transparent),
                left: area.top_left.x as u16,
                top: area.top_left.y as u16,
                width: area.size.width as u16,
                height: area.size.height as u16,
                buffer: buffer.into(),
                ..Frame::default()
            })?;
            previous = Some(indices);
        }
        Ok(())
    }
}

/// Returns the area in which a frame differs from the previous frame, and the color indices of the
/// pixels in this area. Unchanged pixels in the area are transparent.
fn difference(
    previous: Option<&[u8]>,
    current: &[u8],
    size: Size,
    transparent: u8,
) -> (Rectangle, Vec<u8>) {
    let Some(previous) = previous else {
        return (Rectangle::new(Point::zero(), size), current.to_vec());
    };
    let area = changed_area::<1>(previous, current, size.width);
    let pairs = previous.iter().zip(current);
    let drawn: Vec<u8> = pairs
        .map(|(old, new)| if old == new { transparent } else { *new })
        .collect();
    (area, crop::<1>(&drawn, size.width, &area))
}
