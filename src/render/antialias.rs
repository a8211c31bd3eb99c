//! Adaptive antialiasing: more rays for pixels that differ from a neighbor (Whitted 1980).
//!
//! The renderer first traces one camera ray through the center of each pixel. A pixel is at an edge
//! if its object, material, incident light or color differs from that of a horizontal or vertical
//! neighbor. Through each pixel at an edge, the renderer traces a fixed pattern of further rays.
//! The color of such a pixel is the mean of the center ray and the further rays.
//!
//! Whitted traced rays through the corners of pixels and subdivided pixels recursively. This
//! renderer traces rays through the centers of pixels, as [`Renderer`](crate::Renderer) does.
//! Pixels that are not at an edge therefore look the same with both renderers. Because the pattern
//! of rays is fixed, memory for two lines is enough.

mod error;
mod fingerprint;
mod pattern;
mod picture;
mod sample;
mod sampled_line;

pub use error::AntialiasError;
pub use pattern::SampleCount;
pub use picture::AntialiasedPicture;
pub use sample::AaSample;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};

use crate::observer::{Observer, Pair};
use crate::prepare::PreparedScene;
use crate::render::bounds::Bounds;
use crate::render::camera_rays::CameraRays;
use crate::render::canvas::Canvas;
use crate::render::column_range::ColumnRange;
use crate::render::row_span::RowSpan;
use crate::render::scanline::{ScanlineTracer, TracedPixels};
use crate::render::scanline_methods::scanline_methods;
use crate::render::{DisplayColor, Output};
use fingerprint::Fingerprint;
use pattern::{GRID, MAX_SIDE};
use sampled_line::SampledLine;

/// Draws a scene with smooth edges, line by line.
///
/// The renderer takes 0.9 KB of memory. In addition, the caller provides one [`AaSample`] of 16
/// bytes for each pixel of two lines. These samples take 10 KB for a picture that is 320 pixels
/// wide.
///
/// Lines can be requested in any order and more than once. The order changes the cost but not the
/// pixels. If lines are requested from top to bottom, each line is traced once. Requesting the most
/// recent line again costs nothing. A request for any other line costs as much as tracing three
/// lines.
///
/// Samples are clipped to 0..=1 before they are averaged. Otherwise a highlight brighter than white
/// would dominate the mean, and its edge would stay jagged.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use whitted::render::{AaSample, AntialiasedRenderer, SampleCount};
/// use whitted::{Camera, Scene, SceneBuffer, real, vec3};
///
/// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
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
    /// Camera rays of a picture that has [`GRID`] times the width and [`GRID`] times the height.
    /// The further rays are taken from these rays.
    fine_rays: CameraRays,
    samples: SampleCount,
    /// Samples of two lines: the last even line and the last odd line that have been traced.
    lines: [&'m mut [AaSample]; 2],
    /// Columns to draw. The columns next to them are traced too, because edge detection compares
    /// neighbors.
    columns: ColumnRange,
    /// Number of the last finished line. The line below has been traced too, but its edge pixels
    /// have not been refined.
    finished: Option<u32>,
    output: Output,
    fingerprint: Fingerprint,
    observer: O,
}

impl<'s, 'm> AntialiasedRenderer<'s, 'm> {
    /// Returns a renderer for a picture of `size` pixels. Each side may have at most 8191 pixels.
    /// The renderer uses the first `2 * size.width` samples of `memory`.
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
    /// Returns a renderer that reports every ray to `observer`. For the other parameters see
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
        let rays = CameraRays::new(&scene.settings.camera, width, height);
        Ok(Self {
            tracer: ScanlineTracer::new(scene),
            columns: rays.columns(),
            rays,
            fine_rays: CameraRays::new(&scene.settings.camera, GRID * width, GRID * height),
            samples,
            lines: [even, odd],
            finished: None,
            output: Output::of(scene),
            fingerprint: Fingerprint::default(),
            observer,
        })
    }

    scanline_methods!();

    /// Draws the whole picture, from top to bottom. The top left pixel of the picture is at the top
    /// left of the target's bounding box. Pixels outside the bounding box are not traced.
    ///
    /// [`Picture::antialiased`](crate::render::Picture::antialiased) draws at any position.
    ///
    /// # Errors
    /// Drawing stops at the first error of the display and returns that error.
    pub fn draw<D>(&mut self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let result = self.draw_at::<D, false>(target.bounding_box().top_left, target);
        self.set_columns(self.rays.columns());
        result
    }

    /// Draws the visible part of a picture whose top left pixel is at `origin`. If `TRANSPARENT` is
    /// true, only pixels whose center ray hits an object are drawn.
    fn draw_at<D, const TRANSPARENT: bool>(
        &mut self,
        origin: Point,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let area = target.bounding_box();
        let bounds = Bounds::visible(origin, self.size(), [&area, &area]);
        self.set_columns(ColumnRange {
            from: bounds.left,
            to: bounds.right,
            spacing: 0,
        });
        let mut canvas = Canvas::<D, TRANSPARENT>::new(target, origin, self.output);
        for y in bounds.top..bounds.bottom {
            let row = RowSpan::line(y, self.columns);
            canvas.fill_line(&row, self.pixels(y))?;
            if self.observer.is_interrupted() {
                break;
            }
        }
        Ok(())
    }

    /// Sets the columns to draw.
    fn set_columns(&mut self, columns: ColumnRange) {
        if (columns.from, columns.to) != (self.columns.from, self.columns.to) {
            self.columns = columns;
            self.finished = None;
        }
    }

    /// Returns the drawn columns of a line and the columns next to them.
    fn traced_columns(&self) -> ColumnRange {
        let ColumnRange { from, to, spacing } = self.columns;
        ColumnRange {
            from: from.saturating_sub(1),
            to: self.rays.width.min(to + 1),
            spacing,
        }
    }

    /// Returns the pixels of line `y`.
    fn pixels(&mut self, y: u32) -> impl TracedPixels {
        self.finish(y);
        let is_finished = self.finished == Some(y);
        let columns = self.columns;
        let samples = part(self.lines[y as usize % 2], columns);
        SampledLine::new(columns.from, if is_finished { samples } else { &[] })
    }

    /// Traces line `y` and refines its edge pixels. Does nothing if `y` is the last finished line.
    /// If the observer interrupts the renderer, no line is finished.
    fn finish(&mut self, y: u32) {
        if y >= self.rays.height || self.finished == Some(y) {
            return;
        }
        let above = y.checked_sub(1);
        let finished = self.finished.take();
        if above.is_none() || finished != above {
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
        if !self.observer.is_interrupted() {
            self.finished = Some(y);
        }
    }

    /// Traces a ray through the center of each pixel of line `y`, and marks pixels that differ from
    /// a neighbor in the same line.
    fn trace_line(&mut self, y: u32) {
        let columns = self.traced_columns();
        let line = part(self.lines[y as usize % 2], columns);
        let mut both = Pair(&mut self.fingerprint, &mut self.observer);
        let mut pixels = self.tracer.pixels(&self.rays, y, columns, &mut both);
        for sample in &mut *line {
            let Some((_, color)) = pixels.next() else {
                return;
            };
            let is_miss = pixels.take_miss();
            *sample = AaSample::new(color, pixels.tracer.observer.0.hash, is_miss);
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

    /// Compares the two stored lines and marks each pixel that differs from its vertical neighbor.
    fn compare_lines(&mut self) {
        let [even, odd] = &mut self.lines;
        for (a, b) in even.iter_mut().zip(odd.iter_mut()) {
            a.compare(b);
        }
    }

    /// Traces the pattern of rays through each edge pixel of line `y`.
    fn refine(&mut self, y: u32) {
        let line = part(self.lines[y as usize % 2], self.columns);
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
            // The further rays do not need the fingerprint. It still observes them, so that the
            // tracer is compiled for only one type of observer.
            let mut both = Pair(&mut self.fingerprint, &mut self.observer);
            let mut pixels = self.tracer.pixels(&self.fine_rays, row, all, &mut both);
            let edges = (self.columns.from..)
                .zip(&mut *line)
                .filter(|(_, it)| it.is_edge());
            for (x, sample) in edges {
                for column in *columns {
                    pixels.skip_to(GRID * x + column);
                    let Some((_, color)) = pixels.next() else {
                        return;
                    };
                    sample.add(color, weight);
                }
            }
        }
    }
}

/// Returns the samples of some columns of a line.
fn part(line: &mut [AaSample], columns: ColumnRange) -> &mut [AaSample] {
    let ColumnRange { from, to, .. } = columns;
    line.get_mut(from as usize..to as usize).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks the size of a renderer on a 64-bit host. On a 32-bit core, a renderer is smaller.
    #[test]
    fn has_documented_size() {
        assert_eq!(size_of::<AaSample>(), 16);
        let size = size_of::<AntialiasedRenderer<'_, '_>>();
        assert!(size <= 870, "{size}");
    }
}
