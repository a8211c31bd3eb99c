//! Renderer with one camera ray per pixel.

mod step;

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Size;

use crate::math::{Color, Radiance};
use crate::observer::Observer;
use crate::prepare::PreparedScene;
use crate::render::camera_rays::CameraRays;
use crate::render::progress::{RenderProgress, Step};
use crate::render::scanline::{PixelIter, ScanlineTracer};
use crate::render::scanline_methods::scanline_methods;
use crate::render::{DisplayColor, Output};

/// Draws a scene with one camera ray per pixel and without a framebuffer.
///
/// [`draw`](Self::draw) draws the whole picture line by line. [`step`](Self::step) splits drawing
/// into steps and can draw from coarse to fine. The aspect ratio of the camera is that of the
/// picture.
///
/// A renderer takes 0.7 KB of memory, mostly for the list of objects that may be visible in a line.
/// Drawing takes about 1.8 KB of stack. It takes 1.4 KB more if the scene has more than 8
/// generations of rays, and 0.6 KB more if the scene has a sphereflake.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use whitted::{Background, Camera, Renderer, Scene, SceneBuffer, color, real, vec3};
///
/// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
/// let sky = Background::Solid(color!(0, 0, 1));
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// let scene = buffer.prepare(&Scene { background: sky, ..Scene::new(camera) }).unwrap();
///
/// let mut display = MockDisplay::<Rgb888>::new();
/// Renderer::new(&scene, display.size()).draw(&mut display).unwrap();
/// assert_eq!(display.get_pixel(Point::new(63, 63)), Some(Rgb888::BLUE));
/// ```
#[derive(Clone, Debug)]
pub struct Renderer<'s, O: Observer = ()> {
    rays: CameraRays,
    tracer: ScanlineTracer<'s>,
    output: Output,
    observer: O,
}

impl<'s> Renderer<'s> {
    /// Returns a renderer for a picture of `size` pixels. The width and the height are clamped to
    /// 65535 pixels.
    pub fn new(scene: &'s PreparedScene<'s>, size: Size) -> Self {
        Self::with_observer(scene, size, ())
    }
}

impl<'s, O: Observer> Renderer<'s, O> {
    /// Returns a renderer that reports every ray to `observer`.
    pub fn with_observer(scene: &'s PreparedScene<'s>, size: Size, observer: O) -> Self {
        Self {
            rays: CameraRays::new(&scene.settings.camera, size.width, size.height),
            tracer: ScanlineTracer::new(scene),
            output: Output::of(scene),
            observer,
        }
    }

    scanline_methods!();

    /// Returns the linear color of pixel (x, y), or black if the pixel is outside the picture.
    /// [`line`](Self::line) returns the same color for this pixel.
    pub fn pixel(&mut self, x: u32, y: u32) -> Color<Radiance> {
        self.tracer.pixel(&self.rays, x, y, &mut self.observer)
    }

    /// Draws the whole picture, from top to bottom. The top left pixel of the picture is at the top
    /// left of the target's bounding box. Pixels outside the bounding box are not traced.
    ///
    /// [`Picture`](crate::render::Picture) draws at any position.
    ///
    /// # Errors
    /// Drawing stops at the first error of the display and returns that error.
    pub fn draw<D>(&mut self, target: &mut D) -> Result<(), D::Error>
    where
        D: DrawTarget<Color: DisplayColor>,
    {
        let area = target.bounding_box();
        self.step(&mut RenderProgress::scanlines(area), Step::Pass, target)
    }

    /// Returns an iterator over the pixels of line `y`. Each pixel is traced when the iterator
    /// reaches it.
    fn pixels(&mut self, y: u32) -> PixelIter<'_, 's, O> {
        let columns = self.rays.columns();
        self.tracer
            .pixels(&self.rays, y, columns, &mut self.observer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks the size of a renderer on a 64-bit host. On a 32-bit core, a renderer is smaller.
    #[test]
    fn has_documented_size() {
        let size = size_of::<Renderer<'_>>();
        assert!(size <= 700, "{size}");
    }
}
