use std::io::{self, Write};

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::OutputImage;
use png::{BitDepth, ColorType, Compression, Encoder, EncodingError};

use super::Output;
use crate::outcome::Outcome;

/// Writes a picture as a PNG.
pub(crate) fn write_png(image: &OutputImage<Rgb888>, output: Output) -> Outcome {
    output.write(|file| Ok(encode(image, file).map_err(io_error)?))
}

fn encode(image: &OutputImage<Rgb888>, file: &mut dyn Write) -> Result<(), EncodingError> {
    let picture = image.as_image_buffer();
    let mut encoder = Encoder::new(file, picture.width(), picture.height());
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(picture.as_raw())?;
    writer.finish()
}

/// Returns the error of the file that a PNG is written to.
pub(crate) fn io_error(error: EncodingError) -> io::Error {
    match error {
        EncodingError::IoError(error) => error,
        other => io::Error::other(other),
    }
}
