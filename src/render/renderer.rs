//! Scanlines of a scene, and what is drawn of them on a display.

pub(super) mod draw;

use embedded_graphics_core::geometry::{Point, Size};

use crate::math::{Color, Radiance};
use crate::observer::Observer;
use crate::prepare::PreparedScene;
use crate::render::camera_rays::CameraRays;
use crate::render::scanline::{PixelIter, ScanlineTracer};
use crate::render::{DisplayColor, Output};

/// Draws a scene line by line, each pixel once, without a framebuffer; or step by
/// step, in other orders too: [`step`](Self::step).
///
/// It takes 0.7 KB, as it holds which objects a line may show. Drawing takes some 1.5 KB
/// of stack, 0.4 KB more where something lets light through, as rays may then have to wait
/// for others, another 1.4 KB for more than 8 generations, and 0.9 KB for a sphereflake.
/// The picture's aspect follows its size.
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
    view: CameraRays,
    raster: ScanlineTracer<'s>,
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
        Self {
            view: CameraRays::new(&scene.settings.camera, size.width, size.height),
            raster: ScanlineTracer::new(scene),
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
        self.pixels(y).map(|(_, color)| color)
    }

    /// The linear color of a single pixel, the same as in its line; black
    /// outside of the picture.
    pub fn pixel(&mut self, x: u32, y: u32) -> Color<Radiance> {
        self.raster.pixel(&self.view, x, y, &mut self.observer)
    }

    /// Traces line `y` into a slice, for example to send it by DMA while the
    /// next is traced. What is longer than the line is left as it is.
    pub fn render_line<P: DisplayColor>(&mut self, y: u32, line: &mut [P]) {
        let output = self.output;
        for (pixel, (x, color)) in line.iter_mut().zip(self.pixels(y)) {
            *pixel = P::from_radiance(color, Point::new(x as i32, y as i32), output);
        }
    }

    /// The pixels of line `y`, with their columns.
    fn pixels(&mut self, y: u32) -> PixelIter<'_, O> {
        let columns = self.view.columns();
        self.raster
            .pixels(&self.view, y, columns, &mut self.observer)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the documentation of [`Renderer`] says; less where pointers are short.
    #[test]
    fn a_renderer_takes_as_many_bytes_as_documented() {
        let size = size_of::<Renderer<'_>>();
        assert!(size <= 700, "{size}");
    }
}
