//! Adaptive antialiasing: more rays for pixels that differ from a neighbor (Whitted 1980).
//!
//! One camera ray goes through the center of each pixel. A pixel is at an edge if object,
//! material, incident light or color differ from a horizontal or vertical neighbor. Such a pixel
//! gets a fixed pattern of further rays and becomes the mean of all of them.
//!
//! Whitted sampled the corners of pixels and subdivided recursively. Sampling centers instead
//! leaves all other pixels as [`Renderer`](crate::Renderer) draws them, and a fixed pattern needs
//! only two lines of memory.

mod error;
mod fingerprint;
mod pattern;
mod sample;

pub use error::AntialiasError;
pub use pattern::SampleCount;
pub use sample::AaSample;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Size;

use crate::math::{Color, Radiance};
use crate::observer::{Observer, Pair};
use crate::prepare::PreparedScene;
use crate::render::camera_rays::CameraRays;
use crate::render::scanline::ScanlineTracer;
use crate::render::scanline_methods::scanline_methods;
use crate::render::{DisplayColor, Output};
use fingerprint::Fingerprint;
use pattern::{GRID, MAX_SIDE};

/// Draws a scene with smooth edges, line by line.
///
/// The renderer takes 0.9 KB. The caller provides one [`AaSample`] of 16 bytes for each pixel of
/// two lines: 10 KB at a width of 320.
///
/// Lines can be requested in any order, repeatedly, with the same result. In order from top to
/// bottom, each line is traced once; the most recent line is free to request again, and any other
/// line costs as much as three lines.
///
/// Samples are clipped to 0..=1 before they are averaged, because a highlight brighter than white
/// would otherwise dominate the mean and keep a jagged edge.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use whitted::render::{AaSample, AntialiasedRenderer, SampleCount};
/// use whitted::{Camera, Real, Scene, SceneBuffer, Vec3};
///
/// let camera = Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33"));
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// let scene = buffer.prepare(&Scene::new(camera)).unwrap();
///
/// let mut display = MockDisplay::<Rgb888>::new();
/// let mut memory = [AaSample::BLACK; 2 * 64];
/// AntialiasedRenderer::new(&scene, display.size(), SampleCount::Four, &mut memory)
///     .unwrap()
///     .draw(&mut display)
///     .unwrap();
/// ```
#[derive(Debug)]
pub struct AntialiasedRenderer<'s, 'm, O: Observer = ()> {
    tracer: ScanlineTracer<'s>,
    rays: CameraRays,
    /// Camera rays of a picture with [`GRID`] times the width and height.
    fine_rays: CameraRays,
    samples: SampleCount,
    /// The even and the odd line that were traced most recently.
    lines: [&'m mut [AaSample]; 2],
    /// The line that was finished most recently. The line below it is traced but not refined.
    finished: Option<u32>,
    output: Output,
    fingerprint: Fingerprint,
    observer: O,
}

impl<'s, 'm> AntialiasedRenderer<'s, 'm> {
    /// Returns a renderer for a picture of `size` pixels, at most 8191 per side, that uses the
    /// first `2 * size.width` samples of `memory`.
    ///
    /// # Errors
    /// An [`AntialiasError`] if `memory` is too short or the picture is too large.
    pub fn new(
        scene: &'s PreparedScene<'s>,
        size: Size,
        samples: SampleCount,
        memory: &'m mut [AaSample],
    ) -> Result<Self, AntialiasError> {
        Self::with_observer(scene, size, samples, memory, ())
    }
}

impl<'s, 'm, O: Observer> AntialiasedRenderer<'s, 'm, O> {
    /// Returns a renderer that reports every ray to `observer`. The other parameters are those of
    /// [`AntialiasedRenderer::new`].
    ///
    /// # Errors
    /// An [`AntialiasError`] if `memory` is too short or the picture is too large.
    pub fn with_observer(
        scene: &'s PreparedScene<'s>,
        size: Size,
        samples: SampleCount,
        memory: &'m mut [AaSample],
        observer: O,
    ) -> Result<Self, AntialiasError> {
        let Size { width, height } = size;
        if width.max(height) > MAX_SIDE {
            return Err(AntialiasError::TooLarge);
        }
        let needed = AntialiasError::TooLittleMemory {
            samples: 2 * width as usize,
        };
        let (even, rest) = memory.split_at_mut_checked(width as usize).ok_or(needed)?;
        let odd = rest.get_mut(..width as usize).ok_or(needed)?;
        Ok(Self {
            tracer: ScanlineTracer::new(scene),
            rays: CameraRays::new(&scene.settings.camera, width, height),
            fine_rays: CameraRays::new(&scene.settings.camera, GRID * width, GRID * height),
            samples,
            lines: [even, odd],
            finished: None,
            output: Output::default(),
            fingerprint: Fingerprint::default(),
            observer,
        })
    }

    scanline_methods!();

    /// Draws the whole picture, from top to bottom.
    ///
    /// # Errors
    /// The first error of the display, which ends drawing.
    pub fn draw<D>(&mut self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        (0..self.size().height).try_for_each(|y| self.draw_line(y, target))
    }

    /// Returns the columns and colors of line `y`.
    fn pixels(&mut self, y: u32) -> impl Iterator<Item = (u32, Color<Radiance>)> {
        self.finish(y);
        let line = &self.lines[y as usize % 2];
        let count = if y < self.rays.height { line.len() } else { 0 };
        (0..).zip(line.iter().take(count).map(AaSample::color))
    }

    /// Traces and refines line `y`, unless it is the line finished most recently.
    fn finish(&mut self, y: u32) {
        if y >= self.rays.height || self.finished == Some(y) {
            return;
        }
        let above = y.checked_sub(1);
        if above.is_none() || self.finished != above {
            if let Some(above) = above {
                self.trace_line(above);
            }
            self.trace_line(y);
            if above.is_some() {
                self.compare_lines();
            }
        }
        if y + 1 < self.rays.height {
            self.trace_line(y + 1);
            self.compare_lines();
        }
        self.refine(y);
        self.finished = Some(y);
    }

    /// Traces line `y` through the centers of its pixels and marks edges within the line.
    fn trace_line(&mut self, y: u32) {
        let line = &mut *self.lines[y as usize % 2];
        let mut both = Pair(&mut self.fingerprint, &mut self.observer);
        let columns = self.rays.columns();
        let mut pixels = self.tracer.pixels(&self.rays, y, columns, &mut both);
        for sample in &mut *line {
            if let Some((_, color)) = pixels.next() {
                *sample = AaSample::new(color, pixels.tracer.observer.0.hash);
            }
        }
        let mut pixels = line.iter_mut();
        let Some(mut left) = pixels.next() else {
            return;
        };
        for right in pixels {
            left.compare(right);
            left = right;
        }
    }

    /// Marks edges between the two lines.
    fn compare_lines(&mut self) {
        let [even, odd] = &mut self.lines;
        for (a, b) in even.iter_mut().zip(odd.iter_mut()) {
            a.compare(b);
        }
    }

    /// Traces the pattern of rays through each edge pixel of line `y`.
    fn refine(&mut self, y: u32) {
        let line = &mut *self.lines[y as usize % 2];
        let weight = self.samples.weight();
        let mut any = false;
        for sample in line.iter_mut().filter(|sample| sample.is_edge()) {
            sample.start(weight);
            any = true;
        }
        if !any {
            return;
        }
        for (row, columns) in (0..).zip(self.samples.rows()) {
            if columns.is_empty() {
                continue;
            }
            let row = GRID * y + row;
            let all = self.fine_rays.columns();
            // The fingerprint is not needed here, but a tracer without it would be a second copy.
            let mut both = Pair(&mut self.fingerprint, &mut self.observer);
            let mut pixels = self.tracer.pixels(&self.fine_rays, row, all, &mut both);
            let edges = (0..).zip(&mut *line).filter(|(_, it)| it.is_edge());
            for (x, sample) in edges {
                for column in *columns {
                    pixels.skip_to(GRID * x + column);
                    if let Some((_, color)) = pixels.next() {
                        sample.add(color, weight);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The limit holds on 64-bit hosts; a 32-bit core needs less.
    #[test]
    fn has_documented_size() {
        assert_eq!(size_of::<AaSample>(), 16);
        let size = size_of::<AntialiasedRenderer<'_, '_>>();
        assert!(size <= 850, "{size}");
    }
}
