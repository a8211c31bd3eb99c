mod kitty;

use std::env;
use std::io::{IsTerminal, stdout};

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::OutputImage;
use image::{DynamicImage, ImageBuffer};

use crate::outcome::Outcome;

/// Smallest width of a picture, in columns of text. If the terminal is narrower or reports no
/// width, the picture has this width.
const MIN_WIDTH: u16 = 40;

/// Shows a picture if stdout is a terminal. Otherwise prints nothing, so that no escape sequences
/// are written to a file or pipe.
///
/// The function does not query the terminal, because a terminal that does not answer would block
/// the program. Environment variables tell what the terminal supports.
pub(crate) fn show(picture: &OutputImage<Rgb888>) -> Outcome {
    if !stdout().is_terminal() || variable("TERM") == "dumb" {
        return Ok(());
    }
    if supports_kitty() {
        return kitty::show(picture);
    }
    let view = picture.as_image_buffer();
    let (width, height) = view.dimensions();
    let Some(buffer) = ImageBuffer::from_raw(width, height, view.as_raw().to_vec()) else {
        return Ok(());
    };
    let config = viuer::Config {
        absolute_offset: false,
        use_kitty: false,
        width: (viuer::terminal_size().0 < MIN_WIDTH).then_some(MIN_WIDTH.into()),
        ..viuer::Config::default()
    };
    viuer::print(&DynamicImage::ImageRgb8(buffer), &config)?;
    Ok(())
}

/// Returns true if the terminal supports kitty's graphics protocol.
fn supports_kitty() -> bool {
    let names = ["TERM", "TERM_PROGRAM"].map(variable);
    names
        .iter()
        .any(|name| name.contains("kitty") || name.contains("ghostty"))
}

fn variable(name: &str) -> String {
    env::var(name).unwrap_or_default()
}
