//! Writes PNG files with 16-bit linear RGB samples, and reads RGB and gray PNG files.

use std::error::Error;
use std::fmt;
use std::fs::File;
use std::io::{BufReader, BufWriter};
use std::path::Path;

use png::{BitDepth, ColorType, ScaledFloat, Transformations};
use whitted::Color;

use crate::picture::Picture;

/// Writes an RGB PNG with 16 bits per channel. The gAMA chunk of the file is 1.0, because the
/// samples are linear.
pub fn write(path: impl AsRef<Path>, picture: &Picture) -> Result<(), PngError> {
    let path = path.as_ref();
    let file = File::create(path).map_err(|error| PngError::new(path, error))?;
    encode(BufWriter::new(file), picture).map_err(|error| PngError::new(path, error))
}

fn encode(file: BufWriter<File>, picture: &Picture) -> Result<(), png::EncodingError> {
    let mut encoder = png::Encoder::new(file, picture.width, picture.height);
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

/// Reads a gray or RGB PNG of up to 16 bits per channel.
///
/// Samples of 8 bits are scaled to 16 bits. Transparency is dropped, and no gamma correction is
/// applied.
pub fn read(path: impl AsRef<Path>) -> Result<Picture, PngError> {
    let path = path.as_ref();
    let file = File::open(path).map_err(|error| PngError::new(path, error))?;
    decode(BufReader::new(file)).map_err(|error| PngError::new(path, error))
}

fn decode(file: BufReader<File>) -> Result<Picture, png::DecodingError> {
    let mut decoder = png::Decoder::new(file);
    // The decoder converts palette indices to RGB, and samples of fewer than 8 bits to 8 bits.
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info()?;
    let size = reader.output_buffer_size();
    let mut bytes = vec![0; size.ok_or(png::DecodingError::LimitsExceeded)?];
    let info = reader.next_frame(&mut bytes)?;
    bytes.truncate(info.buffer_size());
    let samples: Vec<u16> = match info.bit_depth {
        BitDepth::Sixteen => {
            let (pairs, _) = bytes.as_chunks();
            pairs.iter().copied().map(u16::from_be_bytes).collect()
        }
        _ => bytes.iter().map(|byte| u16::from(*byte) * 257).collect(),
    };
    let pixel = |samples: &[u16]| match *samples {
        [r, g, b, ..] => Color::new(r, g, b),
        [gray, ..] => Color::new(gray, gray, gray),
        [] => Color::default(),
    };
    Ok(Picture {
        width: info.width,
        height: info.height,
        pixels: samples
            .chunks_exact(info.color_type.samples())
            .map(pixel)
            .collect(),
    })
}

/// Error while reading or writing a PNG, with the file's path.
#[derive(Debug)]
pub struct PngError {
    path: String,
    error: Box<dyn Error + Send + Sync>,
}

impl PngError {
    fn new(path: &Path, error: impl Error + Send + Sync + 'static) -> Self {
        let path = path.display().to_string();
        let error = Box::new(error);
        Self { path, error }
    }
}

impl fmt::Display for PngError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.path, self.error)
    }
}

impl Error for PngError {}
