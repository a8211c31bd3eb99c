//! Smooth edges: more rays where neighboring pixels differ (Whitted 1980).
//!
//! A ray goes through the center of each pixel. Where the surface, its
//! material, the light on it or the color is another than in a pixel beside,
//! above or below, a fixed pattern of rays follows, and the pixel is the mean.
//! Whitted sampled corners and divided pixels again and again; centers are what
//! a picture without smooth edges consists of, so all other pixels stay as they
//! are, and a fixed pattern needs no memory but two lines.

mod error;
mod fingerprint;
mod pattern;
mod sample;

pub use error::AntialiasError;
pub use pattern::SampleCount;
pub use sample::AaSample;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};

use crate::math::{Color, Radiance};
use crate::observer::{Observer, Pair};
use crate::prepare::PreparedScene;
use crate::render::camera_rays::CameraRays;
use crate::render::progress::RowSpan;
use crate::render::renderer::draw::fill_line;
use crate::render::scanline::ScanlineTracer;
use crate::render::{DisplayColor, Output};
use fingerprint::Fingerprint;
use pattern::{GRID, MAX_SIDE};

/// Draws a scene with smooth edges, line by line.
///
/// It takes 0.9 KB, and of the caller's memory a [`AaSample`] of 16 bytes for each pixel of
/// two lines: 10 KB at a width of 320. Samples are clipped to 0..=1 before their mean is taken:
/// a highlight shows no brighter than white, so its edge against white would else stay jagged.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use whitted::{AaSample, AntialiasedRenderer, Camera, Real, SampleCount, Scene, SceneBuffer, Vec3};
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
    raster: ScanlineTracer<'s>,
    view: CameraRays,
    /// The same with [`GRID`] pixels for each of the picture, in both directions.
    fine: CameraRays,
    samples: SampleCount,
    /// The even and the odd line that were traced last.
    lines: [&'m mut [AaSample]; 2],
    /// The line that was finished last; the one below it is traced.
    finished: Option<u32>,
    output: Output,
    key: Fingerprint,
    observer: O,
}

impl<'s, 'm> AntialiasedRenderer<'s, 'm> {
    /// A renderer of a picture of `size` pixels, at most 8191 a side, which takes twice its width
    /// of `memory`.
    ///
    /// # Errors
    /// The memory is too small, or the picture too large.
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
    /// The same, telling an observer of every ray.
    ///
    /// # Errors
    /// As those of [`AntialiasedRenderer::new`].
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
            raster: ScanlineTracer::new(scene),
            view: CameraRays::new(&scene.settings.camera, width, height),
            fine: CameraRays::new(&scene.settings.camera, GRID * width, GRID * height),
            samples,
            lines: [even, odd],
            finished: None,
            output: Output::default(),
            key: Fingerprint::default(),
            observer,
        })
    }

    /// What the observer has seen so far.
    pub fn observer(&self) -> &O {
        &self.observer
    }

    /// How the picture is shown on the display.
    pub fn output(&self) -> Output {
        self.output
    }

    /// Shows what is drawn from now on in another way.
    pub fn set_output(&mut self, output: Output) {
        self.output = output;
    }

    /// The size of the picture.
    pub fn size(&self) -> Size {
        Size::new(self.view.width, self.view.height)
    }

    /// The linear colors of line `y`, clipped to 0..=1. A line outside of the picture is empty.
    ///
    /// Lines may be asked for in any order and again and are always the same. From top to bottom
    /// each is traced once; the last one again costs nothing, any other what three lines cost.
    pub fn line(&mut self, y: u32) -> impl Iterator<Item = Color<Radiance>> {
        self.pixels(y).map(|(_, color)| color)
    }

    /// Traces line `y` into a slice, as [`Renderer::render_line`](crate::Renderer::render_line)
    /// does.
    pub fn render_line<P: DisplayColor>(&mut self, y: u32, line: &mut [P]) {
        let output = self.output;
        for (pixel, (x, color)) in line.iter_mut().zip(self.pixels(y)) {
            *pixel = P::from_radiance(color, Point::new(x as i32, y as i32), output);
        }
    }

    /// Draws line `y` by one call of `fill_contiguous`.
    ///
    /// # Errors
    /// The display's own; the line can then be drawn again at no further cost.
    pub fn draw_line<D>(&mut self, y: u32, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let row = RowSpan::line(y, self.view.columns());
        let output = self.output;
        fill_line(&row, self.pixels(y), output, target)
    }

    /// Draws the whole picture, top to bottom.
    ///
    /// # Errors
    /// The display's own, at once.
    pub fn draw<D>(&mut self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        (0..self.size().height).try_for_each(|y| self.draw_line(y, target))
    }

    /// The pixels of line `y`, with their columns.
    fn pixels(&mut self, y: u32) -> impl Iterator<Item = (u32, Color<Radiance>)> {
        self.finish(y);
        let line = &self.lines[y as usize % 2];
        let count = if y < self.view.height { line.len() } else { 0 };
        (0..).zip(line.iter().take(count).map(AaSample::color))
    }

    /// Brings line `y` to what is shown.
    fn finish(&mut self, y: u32) {
        if y >= self.view.height || self.finished == Some(y) {
            return;
        }
        let above = y.checked_sub(1);
        if above.is_none() || self.finished != above {
            if let Some(above) = above {
                self.trace_line(above);
            }
            self.trace_line(y);
            if above.is_some() {
                self.compare();
            }
        }
        if y + 1 < self.view.height {
            self.trace_line(y + 1);
            self.compare();
        }
        self.refine(y);
        self.finished = Some(y);
    }

    /// Traces line `y` through the centers of its pixels, and compares neighbors.
    fn trace_line(&mut self, y: u32) {
        let line = &mut *self.lines[y as usize % 2];
        let mut both = Pair(&mut self.key, &mut self.observer);
        let columns = self.view.columns();
        let mut pixels = self.raster.pixels(&self.view, y, columns, &mut both);
        for sample in &mut *line {
            if let Some((_, color)) = pixels.next() {
                *sample = AaSample::new(color, pixels.observer.0.key);
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

    /// Compares the two lines.
    fn compare(&mut self) {
        let [even, odd] = &mut self.lines;
        for (a, b) in even.iter_mut().zip(odd.iter_mut()) {
            a.compare(b);
        }
    }

    /// Traces the pattern of rays through each pixel of line `y` at an edge.
    fn refine(&mut self, y: u32) {
        let line = &mut *self.lines[y as usize % 2];
        let share = self.samples.share();
        let mut any = false;
        for sample in line.iter_mut().filter(|sample| sample.is_edge()) {
            sample.start(share);
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
            let all = self.fine.columns();
            // The key is not needed, but a second copy of the tracer even less.
            let mut both = Pair(&mut self.key, &mut self.observer);
            let mut pixels = self.raster.pixels(&self.fine, row, all, &mut both);
            let edges = (0..).zip(&mut *line).filter(|(_, it)| it.is_edge());
            for (x, sample) in edges {
                for column in *columns {
                    pixels.pass_to(GRID * x + column);
                    if let Some((_, color)) = pixels.next() {
                        sample.add(color, share);
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the documentation of [`AntialiasedRenderer`] says; less where pointers are short.
    #[test]
    fn it_takes_as_many_bytes_as_documented() {
        assert_eq!(size_of::<AaSample>(), 16);
        let size = size_of::<AntialiasedRenderer<'_, '_>>();
        assert!(size <= 850, "{size}");
    }
}
