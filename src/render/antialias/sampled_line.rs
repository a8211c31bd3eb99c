use super::sample::AaSample;
use crate::render::scanline::{TracedPixel, TracedPixels};

/// Iterator over the finished pixels of a line.
pub(super) struct SampledLine<'l> {
    /// Column of the next pixel.
    x: u32,
    samples: &'l [AaSample],
    /// True if the center ray of the most recent pixel hit nothing.
    is_miss: bool,
}

impl<'l> SampledLine<'l> {
    /// Returns an iterator over the pixels of `samples`. The first pixel is in column `x`.
    pub(super) fn new(x: u32, samples: &'l [AaSample]) -> Self {
        Self {
            x,
            samples,
            is_miss: false,
        }
    }
}

impl Iterator for SampledLine<'_> {
    type Item = TracedPixel;

    fn next(&mut self) -> Option<TracedPixel> {
        let (sample, rest) = self.samples.split_first()?;
        let x = self.x;
        self.x += 1;
        self.samples = rest;
        self.is_miss = sample.is_miss();
        Some((x, sample.color()))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.samples.len(), Some(self.samples.len()))
    }
}

impl TracedPixels for SampledLine<'_> {
    fn take_miss(&mut self) -> bool {
        self.is_miss
    }
}
