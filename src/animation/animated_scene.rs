use heapless::Vec;

use super::{Animation, AnimationError, AnimationProblem};
use crate::math::Real;
use crate::scene::{Light, Object, Scene};

/// Room for what moves: copies of a scene's objects and lights.
///
/// Each frame starts from the still scene, so nothing adds up, and frames may be
/// had in any order. The frame is then prepared as any other scene; where only the
/// camera moves, [`Animation::camera`] with
/// [`PreparedScene::set_camera`](crate::PreparedScene::set_camera) does less.
///
/// An object takes 144 bytes, a light 72. Three tracks and four spheres take a
/// Cortex-M3 some 40,000 instructions to move, 30,000 to prepare, and the camera
/// alone 4,500 to set; to draw them at 320x240 takes 73 million.
///
/// ```
/// use whitted::*;
///
/// static SCENE: Scene = Scene {
///     lights: &[Light::point(Vec3::lit("-6", "11", "7"), Color::gray(Real::ONE))],
///     materials: &[Material { kd: Color::lit("0.6", "0.04", "0.03"), ..Material::BLACK }],
///     objects: &[Object::sphere(Vec3::lit("0", "1", "0"), Real::ONE, MaterialId(0))],
///     ..Scene::new(Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33")))
/// };
/// static UP_AND_DOWN: Animation = Animation {
///     duration: Real::lit("2"),
///     looping: true,
///     tracks: &[Track {
///         target: Target::ObjectPosition(0),
///         interpolation: Interpolation::Smooth,
///         keys: &[Keyframe::vector("0", "0", "1", "0"), Keyframe::vector("1", "0", "2", "0"), Keyframe::vector("2", "0", "1", "0")],
///     }],
/// };
///
/// let mut stage = AnimatedScene::<1, 1>::new();
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// for frame in 0..20 {
///     let scene = stage.frame(&SCENE, &UP_AND_DOWN, Real::from(frame) / 10)?;
///     let prepared = buffer.prepare(&scene)?;
///     // Renderer::new(&prepared, display.size()).draw(&mut display)
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct AnimatedScene<const OBJECTS: usize, const LIGHTS: usize> {
    objects: Vec<Object, OBJECTS>,
    lights: Vec<Light, LIGHTS>,
}

impl<const OBJECTS: usize, const LIGHTS: usize> AnimatedScene<OBJECTS, LIGHTS> {
    /// An empty stage.
    pub const fn new() -> Self {
        Self {
            objects: Vec::new(),
            lights: Vec::new(),
        }
    }

    /// The scene as it is at a time, in seconds.
    ///
    /// # Errors
    /// What is wrong with the animation, or does not fit. Values that no scene can
    /// have are found when the frame is prepared.
    pub fn frame<'s>(
        &'s mut self,
        still: &Scene<'s>,
        animation: &Animation<'_>,
        time: Real,
    ) -> Result<Scene<'s>, AnimationError> {
        animation.check(still)?;
        self.objects.clear();
        self.lights.clear();
        self.objects
            .extend_from_slice(still.objects)
            .map_err(|_| AnimationProblem::TooManyObjects.of_all())?;
        self.lights
            .extend_from_slice(still.lights)
            .map_err(|_| AnimationProblem::TooManyLights.of_all())?;
        let mut camera = still.camera;
        animation.apply(time, &mut camera, &mut self.objects, &mut self.lights);
        Ok(Scene {
            camera,
            objects: &self.objects,
            lights: &self.lights,
            ..*still
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the documentation of [`AnimatedScene`] says.
    #[test]
    fn items_take_as_many_bytes_as_documented() {
        assert_eq!(size_of::<Object>(), 144);
        assert_eq!(size_of::<Light>(), 72);
    }
}
