//! Keyframe animation of cameras, objects and lights.
//!
//! An [`Animation`] is plain data that a `static` can hold. An [`AnimatedScene`] applies the
//! animation to a scene. Times are in seconds. All arithmetic uses saturating `I32F32` fixed
//! point, so every platform computes the same frames.

mod animated_scene;
mod error;
mod keyframe;

pub use animated_scene::AnimatedScene;
pub use error::{AnimationError, AnimationProblem};
pub use keyframe::{Interpolation, Keyframe};

use crate::math::{Color, Real, Vec3};
use crate::scene::{Camera, Light, Object, Scene};

/// The longest duration of an animation is 2^24 seconds, about half a year.
const MAX_DURATION: Real = Real::lit("16777216");

/// A set of tracks. Each track animates one property of a scene.
///
/// ```
/// use whitted::{real, vec3};
/// use whitted::animation::{Animation, Interpolation, Keyframe, Target, Track};
///
/// static ONCE_AROUND: Animation = Animation {
///     duration: real!(4),
///     looping: true,
///     tracks: &[
///         Track {
///             target: Target::CameraOrbit,
///             interpolation: Interpolation::Linear,
///             keys: &[
///                 Keyframe::angles(real!(0), real!(0), real!(0)),
///                 Keyframe::angles(real!(4), real!(360), real!(0)),
///             ],
///         },
///         // Moves object 1 up by 2 and down again on a parabola, as if thrown.
///         Track {
///             target: Target::ObjectPosition(1),
///             interpolation: Interpolation::Smooth,
///             keys: &[
///                 Keyframe::vector(real!(0), vec3!(0, 1, 0)),
///                 Keyframe::vector(real!(2), vec3!(0, 3, 0)),
///                 Keyframe::vector(real!(4), vec3!(0, 1, 0)),
///             ],
///         },
///     ],
/// };
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Animation<'a> {
    /// Duration of the animation in seconds, above 0 and at most 2^24.
    pub duration: Real,
    /// True if the animation repeats. If it does not repeat, the scene keeps its final state
    /// after the end.
    pub looping: bool,
    /// The tracks of the animation.
    pub tracks: &'a [Track<'a>],
}

/// Animation of one property of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Track<'a> {
    /// Property that the track animates.
    pub target: Target,
    /// Method of interpolation between the keyframes of the track.
    pub interpolation: Interpolation,
    /// Keyframes of the track, in order of time. Before the first keyframe, the property has
    /// the value of the first keyframe. After the last keyframe, the property has the value of
    /// the last keyframe.
    pub keys: &'a [Keyframe],
}

/// A property of a scene that a track animates. Objects and lights are numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Target {
    /// Position of the camera: [`Camera::eye`].
    CameraEye,
    /// Point that the camera looks at: [`Camera::look_at`].
    CameraLookAt,
    /// Vertical field of view of the camera in degrees: [`Camera::fovy_deg`].
    CameraFovy,
    /// Yaw and pitch, in degrees, that the animation passes to [`Camera::orbited`]. This orbit
    /// applies to the camera that results from the other camera tracks.
    CameraOrbit,
    /// Position of the object with this number: its field `center` or `origin` or, for a plane,
    /// `point`.
    ObjectPosition(u16),
    /// Radius of the object with this number. The object must be a sphere, cylinder, cone or
    /// sphereflake.
    ObjectRadius(u16),
    /// Position of the light with this number.
    LightPosition(u16),
    /// Color of the light with this number. The track sets both the diffuse and the specular
    /// intensity.
    LightColor(u16),
}

impl Animation<'_> {
    /// Returns a copy of `camera` with the values that the camera tracks give it at `time`, in
    /// seconds.
    ///
    /// If only the camera moves, pass the returned camera to
    /// [`PreparedScene::set_camera`](crate::PreparedScene::set_camera). This takes less time
    /// than preparing the scene again for each frame.
    ///
    /// # Errors
    /// Returns an error for the first track with invalid keyframes, or for an invalid duration.
    pub fn camera(&self, mut camera: Camera, time: Real) -> Result<Camera, AnimationError> {
        self.check_keys()?;
        self.move_camera(&mut camera, self.local_time(time));
        Ok(camera)
    }

    /// Evaluates all tracks at `time` and writes their values into the parts of a scene.
    fn apply(&self, time: Real, camera: &mut Camera, objects: &mut [Object], lights: &mut [Light]) {
        let time = self.local_time(time);
        self.move_camera(camera, time);
        for track in self.tracks {
            let value = || self.value(track, time);
            match track.target {
                Target::ObjectPosition(index) => {
                    if let Some(object) = objects.get_mut(usize::from(index)) {
                        *object.shape.position_mut() = value();
                    }
                }
                Target::ObjectRadius(index) => {
                    let object = objects.get_mut(usize::from(index));
                    if let Some(radius) = object.and_then(|object| object.shape.radius_mut()) {
                        *radius = value().x;
                    }
                }
                Target::LightPosition(index) => {
                    if let Some(light) = lights.get_mut(usize::from(index)) {
                        light.position = value();
                    }
                }
                Target::LightColor(index) => {
                    if let Some(light) = lights.get_mut(usize::from(index)) {
                        let Vec3 { x, y, z } = value();
                        *light = Light::point(light.position, Color::new(x, y, z));
                    }
                }
                Target::CameraEye
                | Target::CameraLookAt
                | Target::CameraFovy
                | Target::CameraOrbit => {}
            }
        }
    }

    fn move_camera(&self, camera: &mut Camera, time: Real) {
        let mut orbit = None;
        for track in self.tracks {
            let value = || self.value(track, time);
            match track.target {
                Target::CameraEye => camera.eye = value(),
                Target::CameraLookAt => camera.look_at = value(),
                Target::CameraFovy => camera.fovy_deg = value().x,
                Target::CameraOrbit => orbit = Some(value()),
                _ => {}
            }
        }
        if let Some(angles) = orbit {
            *camera = camera.orbited(angles.x, angles.y);
        }
    }

    /// Maps any time to a time within the duration of the animation. A repeating animation
    /// wraps the time around. Other animations clamp the time.
    fn local_time(&self, time: Real) -> Real {
        if self.looping {
            time.checked_rem_euclid(self.duration).unwrap_or(Real::ZERO)
        } else {
            time.clamp(Real::ZERO, self.duration.max(Real::ZERO))
        }
    }

    fn value(&self, track: &Track<'_>, time: Real) -> Vec3<Real> {
        let period = self.looping.then_some(self.duration);
        keyframe::value(track.keys, track.interpolation, period, time)
    }

    /// Checks the animation's duration and the times of all keyframes.
    fn check_keys(&self) -> Result<(), AnimationError> {
        if self.duration <= 0 || self.duration > MAX_DURATION {
            return Err(AnimationProblem::Duration.in_animation());
        }
        for (track, index) in self.tracks.iter().zip(0..) {
            keyframe::check(track.keys, self.duration)
                .map_err(|problem| problem.in_track(index))?;
        }
        Ok(())
    }

    /// Checks that the animation can be applied to `scene`. [`AnimatedScene::frame`] also does
    /// this check for each frame.
    ///
    /// # Errors
    /// Returns an error for the first track with invalid keyframes or an invalid target, or for
    /// an invalid duration.
    pub fn check(&self, scene: &Scene<'_>) -> Result<(), AnimationError> {
        self.check_keys()?;
        let lights = scene.lights.len();
        for (track, index) in self.tracks.iter().zip(0..) {
            let problem = match track.target {
                Target::ObjectPosition(object) => {
                    missing(object, scene.objects.len(), AnimationProblem::NoSuchObject)
                }
                Target::ObjectRadius(number) => match scene.objects.get(usize::from(number)) {
                    Some(object) if object.shape.has_radius() => None,
                    Some(_) => Some(AnimationProblem::NoRadius(number)),
                    None => Some(AnimationProblem::NoSuchObject(number)),
                },
                Target::LightPosition(light) | Target::LightColor(light) => {
                    missing(light, lights, AnimationProblem::NoSuchLight)
                }
                _ => None,
            };
            if let Some(problem) = problem {
                return Err(problem.in_track(index));
            }
        }
        Ok(())
    }
}

/// Returns `None` if a scene with `count` items has an item with this number. Otherwise returns
/// the given problem.
fn missing(
    number: u16,
    count: usize,
    problem: fn(u16) -> AnimationProblem,
) -> Option<AnimationProblem> {
    (usize::from(number) >= count).then(|| problem(number))
}
