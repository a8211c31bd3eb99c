use std::io::{self, Write};

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::Rectangle;
use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use super::difference::{changed_area, crop};
use super::frames::Frames;
use super::palette::Palette;
use super::samples::samples;
use super::schedule::Schedule;
use crate::outcome::Outcome;

/// Unit of frame delays: 1/100 s.
const UNITS_PER_SECOND: u32 = 100;

/// Shortest delay of a frame. Most viewers show a frame with a shorter delay for 10 units.
const MIN_DELAY: u64 = 2;

/// Returns the delays of the frames, or an error if a GIF cannot have these delays.
pub(super) fn delays(schedule: &Schedule) -> Result<Vec<u16>, String> {
    let delays = schedule.delays(UNITS_PER_SECOND);
    if delays.iter().any(|delay| *delay < MIN_DELAY) {
        let help = "use --fps 50 or fewer --frames, or write an animated PNG, FILE.apng";
        return Err(format!(
            "a GIF has at most 50 frames per second\n  help: {help}"
        ));
    }
    let delays = delays.into_iter().map(u16::try_from);
    delays.collect::<Result<_, _>>().map_err(|_| {
        let help = "use a larger --fps or --frames, or write an animated PNG, FILE.apng";
        format!("a frame of a GIF lasts at most 655.35 s\n  help: {help}")
    })
}

/// Writes a GIF. All frames share a palette, which is learned from samples of the frames before the
/// first frame is written.
pub(super) fn write(frames: &mut Frames<'_>, delays: &[u16], file: &mut dyn Write) -> Outcome {
    let mut palette = Palette::new(&samples(frames)?, frames.is_dithered());
    let size = frames.size();
    let mut encoder = start(file, size, &palette, frames.schedule.looping).map_err(io_error)?;
    let transparent = palette.transparent();
    let mut previous = None;
    for (index, delay) in delays.iter().enumerate() {
        let image = frames.draw(index)?;
        let indices = palette.indices(image.as_image_buffer().as_raw(), size.width);
        drop(image);
        let (area, buffer) = difference(previous.as_deref(), &indices, size, transparent);
        let frame = Frame {
            delay: *delay,
            dispose: DisposalMethod::Keep,
            transparent: Some(transparent),
            left: area.top_left.x as u16,
            top: area.top_left.y as u16,
            width: area.size.width as u16,
            height: area.size.height as u16,
            buffer: buffer.into(),
            ..Frame::default()
        };
        encoder.write_frame(&frame).map_err(io_error)?;
        previous = Some(indices);
    }
    // This call writes the end of the file.
    encoder.into_inner().map_err(io_error)?;
    Ok(())
}

fn start<'w>(
    file: &'w mut dyn Write,
    size: Size,
    palette: &Palette,
    looping: bool,
) -> Result<Encoder<&'w mut dyn Write>, EncodingError> {
    // The width and the height fit in 16 bits, because the command line limits them to 8192 pixels.
    let [width, height] = [size.width, size.height].map(|side| side as u16);
    let mut encoder = Encoder::new(file, width, height, &palette.colors())?;
    if looping {
        encoder.set_repeat(Repeat::Infinite)?;
    }
    Ok(encoder)
}

/// Returns the error of the file that a GIF is written to.
fn io_error(error: EncodingError) -> io::Error {
    match error {
        EncodingError::Io(error) => error,
        other => io::Error::other(other),
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
