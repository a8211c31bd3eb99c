//! Transfer functions and dithering, which convert linear radiance to the levels of a display.

mod dither;
mod transfer;

pub use dither::Dither;

pub use crate::scene::Transfer;

use crate::prepare::PreparedScene;

/// Conversion of linear radiance to the levels of a display.
///
/// A renderer starts with the transfer function of its scene, and dithers channels of fewer than
/// 8 bits.
///
/// ```
/// use embedded_graphics::prelude::Size;
/// use whitted::render::{Dither, Output, Transfer};
/// use whitted::{Camera, Renderer, Scene, SceneBuffer, real, vec3};
///
/// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
/// let scene = Scene { transfer: Transfer::Srgb, ..Scene::new(camera) };
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// let scene = buffer.prepare(&scene)?;
///
/// let mut renderer = Renderer::new(&scene, Size::new(240, 240));
/// renderer.set_output(Output { dither: Dither::Off, ..renderer.output() });
/// assert_eq!(renderer.output().transfer, Transfer::Srgb);
/// # Ok::<(), whitted::SceneError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Output {
    /// Transfer function from linear radiance to display values.
    pub transfer: Transfer,
    /// Dithering of values that lie between two levels of a display channel.
    pub dither: Dither,
}

impl Output {
    /// Returns the output with which a renderer of this scene starts.
    pub(crate) fn of(scene: &PreparedScene<'_>) -> Self {
        Self {
            transfer: scene.transfer(),
            ..Self::default()
        }
    }
}
