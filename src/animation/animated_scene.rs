use heapless::Vec;

use super::{Animation, AnimationError, AnimationProblem};
use crate::math::Real;
use crate::scene::{Light, Object, Scene};

/// A buffer for the frames of an animation. The buffer holds copies of a scene's objects and
/// lights.
///
/// The buffer takes 144 bytes per object and 72 bytes per light. Each frame is computed from
/// the scene before animation. Rounding errors therefore do not accumulate, and frames can be
/// requested in any order. A frame must be prepared before it is drawn.
///
/// If only the camera moves, the buffer is not needed. Use [`Animation::camera`] and
/// [`PreparedScene::set_camera`](crate::PreparedScene::set_camera) instead.
///
/// As an example, take a scene of four spheres with three tracks on a Cortex-M3. Animating a
/// frame takes about 40,000 instructions, and preparing it takes 30,000. If only the camera
/// moves, setting the camera takes 4,500 instructions. For comparison, drawing the frame at
/// 320x240 takes 73 million instructions.
///
/// ```
/// use whitted::animation::{AnimatedScene, Animation, Interpolation, Keyframe, Target, Track};
/// use whitted::{
///     Camera, Color, Light, Material, MaterialId, Object, Real, Scene, SceneBuffer, color, real,
///     vec3,
/// };
///
/// static SCENE: Scene = Scene {
///     lights: &[Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE))],
///     materials: &[Material { kd: color!(0.6, 0.04, 0.03), ..Material::BLACK }],
///     objects: &[Object::sphere(vec3!(0, 1, 0), Real::ONE, MaterialId(0))],
///     ..Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)))
/// };
/// static UP_AND_DOWN: Animation = Animation {
///     duration: real!(2),
///     looping: true,
///     tracks: &[Track {
///         target: Target::ObjectPosition(0),
///         interpolation: Interpolation::Smooth,
///         keys: &[
///             Keyframe::vector(real!(0), vec3!(0, 1, 0)),
///             Keyframe::vector(real!(1), vec3!(0, 2, 0)),
///             Keyframe::vector(real!(2), vec3!(0, 1, 0)),
///         ],
///     }],
/// };
///
/// let mut animated = AnimatedScene::<1, 1>::new();
/// let mut buffer = SceneBuffer::<1, 1, 1>::new();
/// for frame in 0..20 {
///     let scene = animated.frame(&SCENE, &UP_AND_DOWN, Real::from(frame) / 10)?;
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
    /// Returns an empty buffer.
    pub const fn new() -> Self {
        Self {
            objects: Vec::new(),
            lights: Vec::new(),
        }
    }

    /// Returns the animated scene at `time`, in seconds.
    ///
    /// # Errors
    /// Returns an error of [`Animation::check`], or an error if the buffer is too small for the
    /// scene's objects or lights. Animated values are not validated here but when the frame is
    /// prepared.
    /// values are validated when the frame is prepared.
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
            .map_err(|_| AnimationProblem::TooManyObjects.in_animation())?;
        self.lights
            .extend_from_slice(still.lights)
            .map_err(|_| AnimationProblem::TooManyLights.in_animation())?;
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

    #[test]
    fn items_have_documented_sizes() {
        assert_eq!(size_of::<Object>(), 144);
        assert_eq!(size_of::<Light>(), 72);
    }
}
