use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use png::{BitDepth, DecodingError, Reader, Transformations};
use whitted::Color;

use super::error::PngError;

/// Largest number of pixels, 8192x8192.
const MAX_PIXELS: u64 = 1 << 26;
/// Largest number of pixels of an interlaced picture, 4096x4096. It is decoded as a whole.
const MAX_INTERLACED: u64 = 1 << 24;

/// Reads a gray or RGB PNG of up to 16 bits per channel row by row, so that a large picture takes
/// little memory.
///
/// Samples of 8 bits are scaled to 16 bits. Transparency is dropped, and no gamma correction is
/// applied.
pub struct Rows<'p> {
    path: &'p Path,
    reader: Reader<BufReader<File>>,
    /// Rows that are decoded but not returned yet, if the picture is interlaced.
    decoded: Option<std::vec::IntoIter<Vec<u8>>>,
}

impl<'p> Rows<'p> {
    /// Opens a file and reads its header.
    ///
    /// # Errors
    /// Returns an error if the file is not a PNG or has more than 8192x8192 pixels. An interlaced
    /// picture may have up to 4096x4096 pixels.
    pub fn open(path: &'p Path) -> Result<Self, PngError> {
        let file = File::open(path).map_err(|error| PngError::new(path, error))?;
        let mut decoder = png::Decoder::new(BufReader::new(file));
        // The decoder converts palette indices to RGB, and samples of fewer than 8 bits to 8 bits.
        decoder.set_transformations(Transformations::EXPAND);
        let header = decoder.read_header_info();
        let header = header.map_err(|error| PngError::new(path, error))?;
        let most = match header.interlaced {
            true => MAX_INTERLACED,
            false => MAX_PIXELS,
        };
        let (width, height, is_interlaced) = (header.width, header.height, header.interlaced);
        if u64::from(width) * u64::from(height) > most {
            return Err(PngError::new(path, too_large(width, height, most)));
        }
        let reader = decoder.read_info();
        let mut rows = Self {
            path,
            reader: reader.map_err(|error| PngError::new(path, error))?,
            decoded: None,
        };
        if is_interlaced {
            rows.decode()?;
        }
        Ok(rows)
    }

    /// Returns the width and the height of the picture in pixels.
    pub fn size(&self) -> (u32, u32) {
        let info = self.reader.info();
        (info.width, info.height)
    }

    /// Returns the next row from the top. After the last row, returns `None`.
    ///
    /// # Errors
    /// Returns an error if the file is damaged or truncated.
    pub fn next_row(&mut self) -> Result<Option<Vec<Color<u16>>>, PngError> {
        let (color, depth) = self.reader.output_color_type();
        let channels = color.samples();
        if let Some(decoded) = &mut self.decoded {
            let row = decoded.next();
            return Ok(row.map(|bytes| pixels(&bytes, channels, depth)));
        }
        let row = self.reader.next_row();
        let row = row.map_err(|error| PngError::new(self.path, error))?;
        Ok(row.map(|row| pixels(row.data(), channels, depth)))
    }

    /// Decodes the whole picture.
    fn decode(&mut self) -> Result<(), PngError> {
        let size = self.reader.output_buffer_size();
        let size = size.ok_or(DecodingError::LimitsExceeded);
        let decoded = size.and_then(|size| {
            let mut bytes = vec![0; size];
            let info = self.reader.next_frame(&mut bytes)?;
            let rows = bytes.chunks_exact(info.line_size.max(1));
            Ok(rows.map(<[u8]>::to_vec).collect::<Vec<_>>())
        });
        let decoded = decoded.map_err(|error| PngError::new(self.path, error))?;
        self.decoded = Some(decoded.into_iter());
        Ok(())
    }
}

/// Converts the bytes of a row to pixels of 16 bits per channel.
fn pixels(bytes: &[u8], channels: usize, depth: BitDepth) -> Vec<Color<u16>> {
    let samples: Vec<u16> = match depth {
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
    samples.chunks_exact(channels).map(pixel).collect()
}

/// Returns the reason why a picture with more than `most` pixels is not read.
fn too_large(width: u32, height: u32, most: u64) -> String {
    format!("has {width}x{height} pixels; at most {most} are read")
}
