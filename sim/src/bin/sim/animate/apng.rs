use std::io::Write;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::OutputImage;

use super::difference::{changed_area, crop};
use super::frames::Frames;
use super::schedule::Schedule;
use crate::outcome::Outcome;
use crate::output::io_error;

/// Units of frame delays, as shares of a second. The delay is a 16-bit number.
const UNITS: [u16; 4] = [1000, 100, 10, 1];

/// Delays of the frames and their unit.
pub(super) struct Delays {
    per_second: u16,
    delays: Vec<u16>,
}

/// Returns the delays of the frames in the smallest unit in which all of them fit.
pub(super) fn delays(schedule: &Schedule) -> Result<Delays, String> {
    let fitting = UNITS.into_iter().find_map(|per_second| {
        let delays = schedule.delays(per_second.into());
        let delays = delays
            .into_iter()
            .map(u16::try_from)
            .collect::<Result<_, _>>();
        let delays = delays.ok()?;
        Some(Delays { per_second, delays })
    });
    let delays = fitting.ok_or(
        "a frame of an APNG lasts at most 65535 s\n  help: use a larger --fps or --frames",
    )?;
    if delays.delays.contains(&0) {
        let help = "use a smaller --fps or --frames";
        return Err(format!(
            "a frame of an APNG lasts at least 1 ms\n  help: {help}"
        ));
    }
    Ok(delays)
}

/// Writes an animated PNG with 24-bit colors. The first frame is stored whole. Each later frame
/// stores only the area that differs from the previous frame.
pub(super) fn write(frames: &mut Frames<'_>, delays: &Delays, file: &mut dyn Write) -> Outcome {
    let size = frames.size();
    let mut encoder = png::Encoder::new(file, size.width, size.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    // In APNG, 0 plays means that the animation repeats without end.
    let plays = u32::from(!frames.schedule.looping);
    encoder
        .set_animated(frames.count() as u32, plays)
        .map_err(io_error)?;
    let mut writer = encoder.write_header().map_err(io_error)?;
    let mut previous: Option<OutputImage<Rgb888>> = None;
    for (index, delay) in delays.delays.iter().enumerate() {
        let image = frames.draw(index)?;
        let pixels = image.as_image_buffer().into_raw();
        let area = match &previous {
            Some(previous) => {
                let previous = previous.as_image_buffer().into_raw();
                changed_area::<3>(previous, pixels, size.width)
            }
            None => Rectangle::new(Point::zero(), size),
        };
        let part = crop::<3>(pixels, size.width, &area);
        let delay = (*delay, delays.per_second);
        write_frame(&mut writer, &area, delay, &part).map_err(io_error)?;
        previous = Some(image);
    }
    Ok(writer.finish().map_err(io_error)?)
}

/// Writes the changed area of a frame, with its delay as a fraction of seconds.
fn write_frame(
    writer: &mut png::Writer<&mut dyn Write>,
    area: &Rectangle,
    (delay, per_second): (u16, u16),
    pixels: &[u8],
) -> Result<(), png::EncodingError> {
    let (corner, size) = (area.top_left, area.size);
    writer.set_frame_delay(delay, per_second)?;
    writer.reset_frame_position()?;
    writer.set_frame_dimension(size.width, size.height)?;
    writer.set_frame_position(corner.x as u32, corner.y as u32)?;
    writer.write_image_data(pixels)
}
