use std::time::{Duration, Instant};

use embedded_graphics::pixelcolor::PixelColor;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use indicatif::{ProgressBar, ProgressStyle};

/// A bar on stderr, for work that takes longer than a second.
pub(crate) struct Progress {
    start: Instant,
    lines: u64,
    done: u64,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// The work begins.
    pub(crate) fn new(lines: impl Into<u64>) -> Self {
        Self {
            start: Instant::now(),
            lines: lines.into(),
            done: 0,
            bar: None,
        }
    }

    /// A line is done.
    pub(crate) fn line(&mut self) {
        self.done += 1;
        if self.start.elapsed() > Duration::from_secs(1) {
            self.bar
                .get_or_insert_with(|| bar(self.lines))
                .set_position(self.done);
        }
    }

    /// The work is done: how long it took.
    pub(crate) fn finish(self) -> Duration {
        if let Some(bar) = self.bar {
            bar.finish_and_clear();
        }
        self.start.elapsed()
    }
}

fn bar(lines: u64) -> ProgressBar {
    let bar = ProgressBar::new(lines);
    match ProgressStyle::with_template("{bar:40} line {pos} of {len}, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}

/// A display that tells of each line drawn on it.
pub(crate) struct Watched<'d, D> {
    pub(crate) display: &'d mut D,
    pub(crate) progress: &'d mut Progress,
}

impl<D: Dimensions> Dimensions for Watched<'_, D> {
    fn bounding_box(&self) -> Rectangle {
        self.display.bounding_box()
    }
}

impl<D: DrawTarget> DrawTarget for Watched<'_, D>
where
    D::Color: PixelColor,
{
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Pixel<Self::Color>>,
    {
        self.display.draw_iter(pixels)
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Self::Error>
    where
        I: IntoIterator<Item = Self::Color>,
    {
        self.display.fill_contiguous(area, colors)?;
        self.progress.line();
        Ok(())
    }
}
