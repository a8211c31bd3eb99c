use std::env;
use std::io::{IsTerminal, stdout};

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::OutputImage;
use image::{DynamicImage, ImageBuffer};

use crate::outcome::Outcome;

/// Columns to take where a terminal does not know how many it has.
const LEAST_WIDTH: u16 = 40;

/// Shows a picture if stdout is a terminal: there would be escapes in a pipe.
pub(crate) fn show(picture: &OutputImage<Rgb888>) -> Outcome {
    if !stdout().is_terminal() || variable("TERM") == "dumb" {
        return Ok(());
    }
    let view = picture.as_image_buffer();
    let (width, height) = view.dimensions();
    let Some(buffer) = ImageBuffer::from_raw(width, height, view.as_raw().to_vec()) else {
        return Ok(());
    };
    let config = viuer::Config {
        absolute_offset: false,
        use_kitty: knows_kitty(),
        width: (viuer::terminal_size().0 < LEAST_WIDTH).then_some(LEAST_WIDTH.into()),
        ..viuer::Config::default()
    };
    viuer::print(&DynamicImage::ImageRgb8(buffer), &config)?;
    Ok(())
}

/// Whether the terminal draws pixels by kitty's protocol. Asked of the
/// environment, since a terminal that does not answer would be waited for.
fn knows_kitty() -> bool {
    let names = ["TERM", "TERM_PROGRAM"].map(variable);
    names
        .iter()
        .any(|name| name.contains("kitty") || name.contains("ghostty"))
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_default()
}
