//! Compares two pictures. Computes the PSNR, and the share of pixels that differ by at most 1/255.

use std::error::Error;
use std::fmt;
use std::path::Path;

use whitted::Color;

use crate::picture::Picture;
use crate::png16::Rows;

/// Difference of 1/255 in 16-bit samples: 65535 / 255.
const STEP: u16 = 257;

/// Difference between two pictures. It is computed from the samples as they are, without gamma
/// correction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// Peak signal-to-noise ratio over all pixels and channels, in decibels. It is infinite if the
    /// pictures are equal.
    pub psnr: f64,
    /// Share of the pixels whose channels differ by at most 1/255, from 0 to 1.
    pub within: f64,
}

/// Compares two pictures of the same size.
///
/// The peak signal-to-noise ratio (PSNR) is 10·log10(255² / mean squared error). For this error,
/// the samples are scaled to the range from 0 to 255 without rounding.
pub fn compare(a: &Picture, b: &Picture) -> Result<Comparison, SizesDiffer> {
    let sizes = [(a.width, a.height), (b.width, b.height)];
    if sizes[0] != sizes[1] || a.pixels.len() != b.pixels.len() {
        return Err(SizesDiffer(sizes));
    }
    let mut sums = Sums::default();
    sums.add(&a.pixels, &b.pixels);
    Ok(sums.comparison())
}

/// Compares two PNG files. The sizes in the headers are compared before the pixels are read, and the
/// files are read row by row.
///
/// # Errors
/// Returns an error if a file cannot be read or if the sizes differ.
pub fn compare_files(a: &Path, b: &Path) -> Result<Comparison, Box<dyn Error>> {
    let (mut a, mut b) = (Rows::open(a)?, Rows::open(b)?);
    if a.size() != b.size() {
        return Err(SizesDiffer([a.size(), b.size()]).into());
    }
    let mut sums = Sums::default();
    while let (Some(a), Some(b)) = (a.next_row()?, b.next_row()?) {
        sums.add(&a, &b);
    }
    Ok(sums.comparison())
}

/// Sums over the pixels of two pictures.
#[derive(Default)]
struct Sums {
    /// Squared differences of all samples.
    squares: u64,
    /// Number of pixels whose channels differ by at most 1/255.
    within: usize,
    /// Number of all pixels.
    count: usize,
}

impl Sums {
    fn add(&mut self, a: &[Color<u16>], b: &[Color<u16>]) {
        for (a, b) in a.iter().zip(b) {
            let differences = [a.r.abs_diff(b.r), a.g.abs_diff(b.g), a.b.abs_diff(b.b)];
            self.within += usize::from(differences.iter().all(|difference| *difference <= STEP));
            let squares = differences.map(|difference| u64::from(difference).pow(2));
            self.squares += squares.iter().sum::<u64>();
            self.count += 1;
        }
    }

    fn comparison(&self) -> Comparison {
        let count = self.count as f64;
        let mean = self.squares as f64 / (3.0 * count * f64::from(STEP).powi(2));
        Comparison {
            psnr: 10.0 * (255.0 * 255.0 / mean).log10(),
            within: self.within as f64 / count,
        }
    }
}

impl fmt::Display for Comparison {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { psnr, within } = self;
        if psnr.is_infinite() {
            return write!(
                f,
                "PSNR inf, 100% of pixels within 1/255: the pictures are equal"
            );
        }
        write!(
            f,
            "PSNR {psnr:.2} dB, {:.3}% of pixels within 1/255",
            100.0 * within
        )
    }
}

/// The error for two pictures of different sizes. It has the width and height of each picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SizesDiffer(pub [(u32, u32); 2]);

impl fmt::Display for SizesDiffer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [a, b] = self.0;
        write!(
            f,
            "the sizes differ: {}x{} and {}x{}; compare pictures of the same size",
            a.0, a.1, b.0, b.1
        )
    }
}

impl Error for SizesDiffer {}
