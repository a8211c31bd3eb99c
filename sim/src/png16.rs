//! Writes PNG files with 16-bit linear RGB samples, and reads RGB and gray PNG files.

mod error;
mod rows;

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;

use png::{BitDepth, ColorType, ScaledFloat};

use crate::picture::Picture;
pub use error::PngError;
pub use rows::Rows;

/// Writes an RGB PNG with 16 bits per channel. The gAMA chunk of the file is 1.0, because the
/// samples are linear.
pub fn write(path: impl AsRef<Path>, picture: &Picture) -> Result<(), PngError> {
    let path = path.as_ref();
    let file = File::create(path).map_err(|error| PngError::new(path, error))?;
    encode(BufWriter::new(file), picture).map_err(|error| PngError::new(path, error))
}

/// Encodes a picture like [`write()`] and flushes the writer.
///
/// # Errors
/// Returns an error if the writer fails or if the picture has no pixels.
pub fn encode(writer: impl Write, picture: &Picture) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(writer, picture.width, picture.height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Sixteen);
    encoder.set_source_gamma(ScaledFloat::new(1.0));
    let mut bytes = Vec::with_capacity(6 * picture.pixels.len());
    for pixel in &picture.pixels {
        for sample in [pixel.r, pixel.g, pixel.b] {
            bytes.extend(sample.to_be_bytes());
        }
    }
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&bytes)?;
    writer.finish()
}

/// Reads a PNG as a whole, like [`Rows`].
pub fn read(path: impl AsRef<Path>) -> Result<Picture, PngError> {
    let mut rows = Rows::open(path.as_ref())?;
    let (width, height) = rows.size();
    let mut pixels = Vec::new();
    while let Some(row) = rows.next_row()? {
        pixels.extend(row);
    }
    Ok(Picture {
        width,
        height,
        pixels,
    })
}
