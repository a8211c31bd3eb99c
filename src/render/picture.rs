//! A picture at a position, which is drawn like the other drawables of embedded-graphics.

use core::marker::PhantomData;

use embedded_graphics_core::Drawable;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Dimensions, Point, Size};
use embedded_graphics_core::pixelcolor::PixelColor;
use embedded_graphics_core::primitives::Rectangle;

use crate::prepare::PreparedScene;
use crate::render::{DisplayColor, Output, RenderProgress, Renderer, Step};

/// A picture of a scene at a position on a display.
///
#[doc = concat!(
    "![A copper ball and a turquoise ball hover over a user interface](data:image/png;base64,",
    include_str!("../../docs/images/rustdoc/over_interface.base64"),
    ")"
)]
///
/// A picture is a [`Drawable`] of embedded-graphics. It can lie anywhere on any target: on a
/// display whose coordinates do not begin at (0, 0), partly outside the display, or on a display
/// that is `clipped`, `cropped` or `translated`. Only pixels inside the bounding box of the target
/// are traced. With the Cargo feature `embedded-graphics`, a picture can be moved by `Transform`.
///
/// Drawing creates a [`Renderer`] on the stack, which takes 0.7 KB.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
/// use whitted::render::Picture;
/// use whitted::{Camera, Scene, SceneBuffer, real, vec3};
///
/// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// let scene = buffer.prepare(&Scene::new(camera))?;
///
/// let mut display = MockDisplay::<Rgb565>::new();
/// Picture::new(&scene, Point::new(10, 20), Size::new(32, 24)).draw(&mut display).unwrap();
/// assert_eq!(display.affected_area().top_left, Point::new(10, 20));
/// # Ok::<(), whitted::SceneError>(())
/// ```
///
/// If `TRANSPARENT` is true, the background of the scene is not drawn, see
/// [`transparent`](Self::transparent). `C` is the color type of the display. The compiler usually
/// infers it from the call of `draw`.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'s, C, const TRANSPARENT: bool = false> {
    pub(super) scene: &'s PreparedScene<'s>,
    pub(super) area: Rectangle,
    pub(super) output: Output,
    color: PhantomData<C>,
}

impl<'s, C> Picture<'s, C> {
    /// Returns a picture of `size` pixels whose top left pixel is at `position`. The width and the
    /// height are clamped to 65535 pixels.
    pub fn new(scene: &'s PreparedScene<'s>, position: Point, size: Size) -> Self {
        Self {
            scene,
            area: Rectangle::new(position, size),
            output: Output::default(),
            color: PhantomData,
        }
    }
}

impl<'s, C, const TRANSPARENT: bool> Picture<'s, C, TRANSPARENT> {
    /// Returns the picture with another conversion of linear colors to display colors. Dithering
    /// depends on the position of a pixel in the picture, not on the display.
    pub fn with_output(self, output: Output) -> Self {
        Self { output, ..self }
    }

    /// Returns the picture with a transparent background: pixels whose camera ray hits nothing are
    /// not drawn.
    ///
    /// The background of the scene is still visible in mirrors and through glass. In a progressive
    /// pass, a transparent picture draws single pixels instead of blocks, because blocks would
    /// cover what is behind the picture.
    ///
    /// ```
    /// # use embedded_graphics::mock_display::MockDisplay;
    /// # use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
    /// # use whitted::render::Picture;
    /// # use whitted::{Camera, Material, MaterialId, Object, Scene, SceneBuffer, color, real, vec3};
    /// let ball = Scene {
    ///     materials: &[Material { le: color!(1, 0, 0), ..Material::BLACK }],
    ///     objects: &[Object::sphere(vec3!(0, 0, 0), real!(1), MaterialId(0))],
    ///     ..Scene::new(Camera::new(vec3!(0, 0, 4), vec3!(0, 0, 0), real!(33)))
    /// };
    /// let mut buffer = SceneBuffer::<1, 1, 1>::new();
    /// let scene = buffer.prepare(&ball)?;
    /// let mut display = MockDisplay::<Rgb888>::new();
    /// Picture::new(&scene, Point::zero(), display.size()).transparent().draw(&mut display).unwrap();
    /// assert_eq!(display.get_pixel(Point::new(32, 32)), Some(Rgb888::RED));
    /// assert_eq!(display.get_pixel(Point::new(0, 0)), None);
    /// # Ok::<(), whitted::SceneError>(())
    /// ```
    pub fn transparent(self) -> Picture<'s, C, true> {
        Picture {
            scene: self.scene,
            area: self.area,
            output: self.output,
            color: PhantomData,
        }
    }

    /// Draws the next step of the picture and advances `progress`. See [`Renderer::step`], which
    /// describes steps and errors.
    ///
    /// The area of `progress` is in coordinates of the display. Start with
    /// `RenderProgress::progressive(picture.bounding_box())` or with the part of it that is to be
    /// drawn.
    ///
    /// ```
    /// # use embedded_graphics::mock_display::MockDisplay;
    /// # use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
    /// # use whitted::{Camera, Scene, SceneBuffer, real, vec3};
    /// # let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
    /// # let mut buffer = SceneBuffer::<1, 1, 1>::new();
    /// # let scene = buffer.prepare(&Scene::new(camera))?;
    /// # let mut display = MockDisplay::<Rgb565>::new();
    /// # display.set_allow_overdraw(true);
    /// use whitted::render::{Picture, RenderProgress, Step};
    ///
    /// let picture = Picture::new(&scene, Point::new(10, 20), Size::new(32, 24));
    /// let mut progress = RenderProgress::progressive(picture.bounding_box());
    /// while !progress.is_complete() {
    ///     picture.step(&mut progress, Step::Rays(800), &mut display).unwrap();
    ///     // Read a button, feed the watchdog ...
    /// }
    /// # Ok::<(), whitted::SceneError>(())
    /// ```
    ///
    /// # Errors
    /// Returns the error of the display. The next step repeats the failed call.
    #[inline]
    pub fn step<D>(
        &self,
        progress: &mut RenderProgress,
        step: Step,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        D: DrawTarget<Color = C>,
        C: DisplayColor,
    {
        let mut renderer = Renderer::new(self.scene, self.area.size);
        renderer.set_output(self.output);
        renderer.step_at::<D, TRANSPARENT>(self.area.top_left, progress, step, target)
    }
}

impl<C: PixelColor + DisplayColor, const TRANSPARENT: bool> Drawable
    for Picture<'_, C, TRANSPARENT>
{
    type Color = C;
    type Output = ();

    fn draw<D: DrawTarget<Color = C>>(&self, target: &mut D) -> Result<(), D::Error> {
        let mut progress = RenderProgress::scanlines(self.area);
        self.step(&mut progress, Step::Pass, target)
    }
}

impl<C, const TRANSPARENT: bool> Dimensions for Picture<'_, C, TRANSPARENT> {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

#[cfg(feature = "embedded-graphics")]
impl<C, const TRANSPARENT: bool> embedded_graphics::transform::Transform
    for Picture<'_, C, TRANSPARENT>
{
    fn translate(&self, by: Point) -> Self {
        Self {
            area: self.area.translate(by),
            ..*self
        }
    }

    fn translate_mut(&mut self, by: Point) -> &mut Self {
        self.area.translate_mut(by);
        self
    }
}
