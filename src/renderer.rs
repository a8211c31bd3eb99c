//! Scanlines to a display.

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::primitives::Rectangle;

use crate::camera::{Line, View};
use crate::coverage::Coverage;
use crate::num::Radiance;
use crate::observer::Observer;
use crate::tracer::{Scratch, trace};
use crate::{Color, Output, Pixel, PreparedScene};

/// Draws a scene line by line, each pixel once, without a framebuffer.
///
/// It takes 2.2 KB, as it holds the stack of rays and which objects a line may
/// show: keep it in a `static` or high up on the stack. The picture's aspect
/// follows its size.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use whitted::{Background, Camera, Color, Real, Renderer, Scene, SceneBuffer, Vec3};
///
/// let camera = Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33"));
/// let sky = Background::Solid(Color::lit("0", "0", "1"));
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// let scene = buffer.prepare(&Scene { background: sky, ..Scene::new(camera) }).unwrap();
///
/// let mut display = MockDisplay::<Rgb888>::new();
/// Renderer::new(&scene, display.size()).draw(&mut display).unwrap();
/// assert_eq!(display.get_pixel(Point::new(63, 63)), Some(Rgb888::BLUE));
/// ```
#[derive(Clone, Debug)]
pub struct Renderer<'s, O: Observer = ()> {
    scene: &'s PreparedScene<'s>,
    view: View,
    scratch: Scratch,
    coverage: Coverage,
    output: Output,
    observer: O,
}

impl<'s> Renderer<'s> {
    /// A renderer of a picture of `size` pixels, at most 65535 a side.
    pub fn new(scene: &'s PreparedScene<'s>, size: Size) -> Self {
        Self::with_observer(scene, size, ())
    }
}

impl<'s, O: Observer> Renderer<'s, O> {
    /// A renderer that tells an observer of every ray.
    pub fn with_observer(scene: &'s PreparedScene<'s>, size: Size, observer: O) -> Self {
        let view = View::new(&scene.settings.camera, size.width, size.height);
        Self {
            scene,
            view,
            scratch: Scratch::default(),
            coverage: Coverage::default(),
            output: Output::default(),
            observer,
        }
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

    /// The linear colors of line `y`, traced one by one as they are asked
    /// for. A line outside of the picture is empty.
    pub fn line(&mut self, y: u32) -> impl Iterator<Item = Color<Radiance>> {
        self.coverage.look(self.scene, &self.view, y);
        Pixels {
            rays: self.view.line(y),
            x: 0,
            scene: self.scene,
            coverage: &mut self.coverage,
            scratch: &mut self.scratch,
            observer: &mut self.observer,
        }
    }

    /// The linear color of a single pixel, the same as in its line; black
    /// outside of the picture.
    pub fn pixel(&mut self, x: u32, y: u32) -> Color<Radiance> {
        let mut rays = self.view.line(y);
        rays.skip_to(x);
        rays.next().map_or(Color::<Radiance>::BLACK, |ray| {
            trace(
                self.scene,
                &ray,
                None,
                &mut self.scratch,
                &mut self.observer,
            )
        })
    }

    /// Traces line `y` into a slice, for example to send it by DMA while the
    /// next is traced. What is longer than the line is left as it is.
    pub fn render_line<P: Pixel>(&mut self, y: u32, line: &mut [P]) {
        for (pixel, color) in line.iter_mut().zip(self.shown(y)) {
            *pixel = color;
        }
    }

    /// Draws line `y` by one call of `fill_contiguous`.
    ///
    /// # Errors
    /// The display's own.
    pub fn draw_line<D>(&mut self, y: u32, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget,
        D::Color: Pixel,
    {
        let row = Rectangle::new(Point::new(0, y as i32), Size::new(self.size().width, 1));
        target.fill_contiguous(&row, self.shown(y))
    }

    /// Line `y` as a display shows it, from left to right.
    fn shown<P: Pixel>(&mut self, y: u32) -> impl Iterator<Item = P> {
        let output = self.output;
        let mut at = Point::new(0, y as i32);
        self.line(y).map(move |color| {
            let pixel = P::show(color, at, output);
            at.x += 1;
            pixel
        })
    }

    /// Draws the whole picture, top to bottom.
    ///
    /// # Errors
    /// The display's own, at once.
    pub fn draw<D>(&mut self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget,
        D::Color: Pixel,
    {
        (0..self.size().height).try_for_each(|y| self.draw_line(y, target))
    }
}

/// The pixels of a line as they are traced.
struct Pixels<'r, O> {
    rays: Line,
    x: u32,
    scene: &'r PreparedScene<'r>,
    coverage: &'r mut Coverage,
    scratch: &'r mut Scratch,
    observer: &'r mut O,
}

impl<O: Observer> Iterator for Pixels<'_, O> {
    type Item = Color<Radiance>;

    #[inline]
    fn next(&mut self) -> Option<Self::Item> {
        let ray = self.rays.next()?;
        let candidates = self.coverage.at(self.x);
        self.x += 1;
        Some(trace(
            self.scene,
            &ray,
            candidates,
            self.scratch,
            self.observer,
        ))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        self.rays.size_hint()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the documentation of [`Renderer`] says; less where pointers are short.
    #[test]
    fn a_renderer_takes_as_many_bytes_as_documented() {
        let size = size_of::<Renderer<'_>>();
        assert!(size <= 2250, "{size}");
    }
}
