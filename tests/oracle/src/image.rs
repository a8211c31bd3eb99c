//! Reads reference images and compares pictures with them.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// Picture of linear colors from 0 to 1, row by row from the top.
#[derive(Clone, Debug)]
pub struct Image {
    pub width: u32,
    pub height: u32,
    pub pixels: Vec<[f64; 3]>,
}

/// Result of comparing two pictures.
#[derive(Clone, Copy, Debug)]
pub struct Comparison {
    /// PSNR in dB over all pixels and channels; infinite for equal pictures.
    pub psnr: f64,
    /// Fraction of pixels, 0 to 1, in which no channel differs by more than 1/255.
    pub within_one: f64,
    /// Index of the pixel with the greatest difference.
    pub worst: usize,
}

/// Reads a 16-bit RGB PNG of linear colors. Panics if the file has another format.
pub fn read_png(path: impl AsRef<Path>) -> Image {
    let path = path.as_ref();
    let name = path.display();
    let file = File::open(path).unwrap_or_else(|error| panic!("{name}: {error}"));
    let mut reader = png::Decoder::new(BufReader::new(file))
        .read_info()
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let size = reader.output_buffer_size().expect("image size overflows");
    let mut bytes = vec![0; size];
    let info = reader
        .next_frame(&mut bytes)
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let format = (info.color_type, info.bit_depth);
    assert_eq!(
        format,
        (png::ColorType::Rgb, png::BitDepth::Sixteen),
        "{name} is not a 16-bit RGB PNG"
    );
    let pixels = bytes[..info.buffer_size()]
        .chunks_exact(6)
        .map(|p| [[p[0], p[1]], [p[2], p[3]], [p[4], p[5]]])
        .map(|pixel| pixel.map(|channel| f64::from(u16::from_be_bytes(channel)) / 65535.0))
        .collect();
    Image {
        width: info.width,
        height: info.height,
        pixels,
    }
}

/// Compares two pictures of equal size in linear light, clipped to [0, 1].
pub fn compare(picture: &[[f64; 3]], reference: &[[f64; 3]]) -> Comparison {
    assert_eq!(picture.len(), reference.len(), "pictures differ in size");
    let (mut squares, mut within, mut worst) = (0.0, 0, (0.0, 0));
    for (index, (a, b)) in picture.iter().zip(reference).enumerate() {
        let mut greatest = 0.0_f64;
        for (a, b) in a.iter().zip(b) {
            let difference = 255.0 * (a.clamp(0.0, 1.0) - b.clamp(0.0, 1.0));
            squares += difference * difference;
            greatest = greatest.max(difference.abs());
        }
        within += usize::from(greatest <= 1.0);
        if greatest > worst.0 {
            worst = (greatest, index);
        }
    }
    let count = reference.len() as f64;
    Comparison {
        psnr: 10.0 * (255.0 * 255.0 * 3.0 * count / squares).log10(),
        within_one: within as f64 / count,
        worst: worst.1,
    }
}
