//! Motion: key frames of what moves in a scene, which `static`s can hold.
//!
//! Time is in seconds, all arithmetic in fixed point, so a frame is the same on
//! every target. Orbits alone take sines, from `angle`.

mod animated_scene;
mod error;
mod keyframe;

pub use animated_scene::AnimatedScene;
pub use error::{AnimationError, AnimationProblem};
pub use keyframe::{Interpolation, Keyframe};

use crate::math::{Color, Real, Vec3};
use crate::scene::{Camera, Light, Object, Scene};

/// The longest animation, in seconds: 2^24, half a year.
const LONGEST: Real = Real::lit("16777216");

/// How a scene moves.
///
/// A [`AnimatedScene`] has the room to apply it to a scene.
///
/// ```
/// use whitted::{Keyframe, Real};
/// use whitted::animation::{Animation, Interpolation, Target, Track};
///
/// static ONCE_AROUND: Animation = Animation {
///     duration: Real::lit("4"),
///     looping: true,
///     tracks: &[
///         Track {
///             target: Target::CameraOrbit,
///             interpolation: Interpolation::Linear,
///             keys: &[Keyframe::angles("0", "0", "0"), Keyframe::angles("4", "360", "0")],
///         },
///         // Thrown up by 2 and caught: a parabola.
///         Track {
///             target: Target::ObjectPosition(1),
///             interpolation: Interpolation::Smooth,
///             keys: &[Keyframe::vector("0", "0", "1", "0"), Keyframe::vector("2", "0", "3", "0"), Keyframe::vector("4", "0", "1", "0")],
///         },
///     ],
/// };
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Animation<'a> {
    /// How long it takes, in seconds: above 0, at most 2^24.
    pub duration: Real,
    /// Whether it then begins anew; else all stays where it is.
    pub looping: bool,
    /// What moves.
    pub tracks: &'a [Track<'a>],
}

/// The motion of one thing.
#[derive(Clone, Copy, Debug)]
pub struct Track<'a> {
    /// What it moves.
    pub target: Target,
    /// How it gets from key to key.
    pub interpolation: Interpolation,
    /// Where it is when. Before the first key it is where that says, after the last
    /// where that says.
    pub keys: &'a [Keyframe],
}

/// What a track moves. Objects and lights are numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Target {
    /// The eye.
    CameraEye,
    /// What the camera looks at.
    CameraLookAt,
    /// The field of view, in degrees.
    CameraFovy,
    /// Yaw and pitch, in degrees, of [`Camera::orbited`]; once the other tracks
    /// have moved the camera.
    CameraOrbit,
    /// The `center` or `origin` of an object, the `point` of a plane.
    ObjectPosition(u16),
    /// The radius of a sphere, cylinder, cone or sphereflake.
    ObjectRadius(u16),
    /// The position of a light.
    LightPosition(u16),
    /// The color of a light, diffuse and specular.
    LightColor(u16),
}

impl Animation<'_> {
    /// A scene's camera as it has moved at a time, in seconds; the first part of what a
    /// [`AnimatedScene`] does, for
    /// [`PreparedScene::set_camera`](crate::PreparedScene::set_camera).
    ///
    /// # Errors
    /// What is wrong with the animation.
    pub fn camera(&self, mut camera: Camera, time: Real) -> Result<Camera, AnimationError> {
        self.check_keys()?;
        self.move_camera(&mut camera, self.moment(time));
        Ok(camera)
    }

    /// Moves what moves.
    fn apply(&self, time: Real, camera: &mut Camera, objects: &mut [Object], lights: &mut [Light]) {
        let time = self.moment(time);
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

    /// A time within the animation.
    fn moment(&self, time: Real) -> Real {
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

    /// Checks all that can be known without a scene.
    fn check_keys(&self) -> Result<(), AnimationError> {
        if self.duration <= 0 || self.duration > LONGEST {
            return Err(AnimationProblem::Duration.of_all());
        }
        for (track, index) in self.tracks.iter().zip(0..) {
            keyframe::check(track.keys, self.duration).map_err(|problem| problem.of(index))?;
        }
        Ok(())
    }

    /// Checks the animation of a scene; a [`AnimatedScene`] does so for each frame.
    ///
    /// # Errors
    /// The first track that cannot be, and what is wrong with it.
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
                return Err(problem.of(index));
            }
        }
        Ok(())
    }
}

fn missing(
    number: u16,
    count: usize,
    problem: fn(u16) -> AnimationProblem,
) -> Option<AnimationProblem> {
    (usize::from(number) >= count).then(|| problem(number))
}
