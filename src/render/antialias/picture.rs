use core::cell::RefCell;

use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::Dimensions;
use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::primitives::Rectangle;

use super::{AaSample, AntialiasError, AntialiasedRenderer, SampleCount};
use crate::render::DisplayColor;
use crate::render::picture::Picture;

/// A [`Picture`] with smooth edges. [`Picture::antialiased`] creates it.
///
/// Drawing creates an [`AntialiasedRenderer`] on the stack, which takes 0.9 KB. To draw line by
/// line, use an [`AntialiasedRenderer`] and a `cropped` display.
#[derive(Clone, Copy, Debug)]
pub struct AntialiasedPicture<'s, 'm, C, const TRANSPARENT: bool = false> {
    picture: Picture<'s, C, TRANSPARENT>,
    samples: SampleCount,
    memory: &'m RefCell<[AaSample]>,
}

impl<'s, C, const TRANSPARENT: bool> Picture<'s, C, TRANSPARENT> {
    /// Returns the picture with smooth edges. `memory` needs two samples for each pixel of the
    /// picture's width. Several pictures can use the same memory.
    ///
    /// Edges against a transparent background are smooth too: they blend into the background of the
    /// scene. Give the scene a background that suits what is behind the picture.
    ///
    /// ```
    /// # use embedded_graphics::mock_display::MockDisplay;
    /// # use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
    /// # use whitted::{Camera, Scene, SceneBuffer, real, vec3};
    /// # let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
    /// # let mut buffer = SceneBuffer::<1, 1, 1>::new();
    /// # let scene = buffer.prepare(&Scene::new(camera)).unwrap();
    /// # let mut display = MockDisplay::<Rgb565>::new();
    /// use core::cell::RefCell;
    /// use whitted::render::{AaSample, Picture, SampleCount};
    ///
    /// let memory = RefCell::new([AaSample::BLACK; 2 * 32]);
    /// Picture::new(&scene, Point::new(10, 20), Size::new(32, 24))
    ///     .antialiased(SampleCount::Four, &memory)?
    ///     .draw(&mut display)
    ///     .unwrap();
    /// # Ok::<(), whitted::render::AntialiasError>(())
    /// ```
    ///
    /// # Errors
    /// An [`AntialiasError`] if `memory` is too short or a side of the picture has more than 8191
    /// pixels.
    pub fn antialiased<'m>(
        self,
        samples: SampleCount,
        memory: &'m RefCell<[AaSample]>,
    ) -> Result<AntialiasedPicture<'s, 'm, C, TRANSPARENT>, AntialiasError> {
        let picture = AntialiasedPicture {
            picture: self,
            samples,
            memory,
        };
        picture.with_renderer(|_| ()).map(|()| picture)
    }
}

impl<C, const TRANSPARENT: bool> AntialiasedPicture<'_, '_, C, TRANSPARENT> {
    /// Calls a function with a renderer of the picture. The memory counts as too short while
    /// another picture uses it.
    fn with_renderer<T>(
        &self,
        draw: impl FnOnce(&mut AntialiasedRenderer<'_, '_>) -> T,
    ) -> Result<T, AntialiasError> {
        let Picture {
            scene,
            area,
            output,
            ..
        } = self.picture;
        let mut memory = self.memory.try_borrow_mut();
        let memory = match &mut memory {
            Ok(memory) => &mut **memory,
            Err(_) => &mut [],
        };
        let mut renderer = AntialiasedRenderer::new(scene, area.size, self.samples, memory)?;
        renderer.set_output(output);
        Ok(draw(&mut renderer))
    }
}

/// Draws the picture, from top to bottom. Draws nothing if the target itself draws an antialiased
/// picture with the same memory.
impl<C: PixelColor + DisplayColor, const TRANSPARENT: bool> Drawable
    for AntialiasedPicture<'_, '_, C, TRANSPARENT>
{
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        let origin = self.picture.area.top_left;
        self.with_renderer(|renderer| renderer.draw_at::<D, TRANSPARENT>(origin, target))
            .unwrap_or(Ok(()))
    }
}

impl<C, const TRANSPARENT: bool> Dimensions for AntialiasedPicture<'_, '_, C, TRANSPARENT> {
    fn bounding_box(&self) -> Rectangle {
        self.picture.area
    }
}

#[cfg(feature = "embedded-graphics")]
impl<C, const TRANSPARENT: bool> embedded_graphics::transform::Transform
    for AntialiasedPicture<'_, '_, C, TRANSPARENT>
{
    fn translate(&self, by: embedded_graphics_core::geometry::Point) -> Self {
        Self {
            picture: self.picture.translate(by),
            ..*self
        }
    }

    fn translate_mut(&mut self, by: embedded_graphics_core::geometry::Point) -> &mut Self {
        self.picture.translate_mut(by);
        self
    }
}
