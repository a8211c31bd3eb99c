use super::{Interpolation, Keyframe};
use crate::math::Real;

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
    /// The tracks of the animation, at most 65,535. If several tracks have the same target, the
    /// last of them applies.
    pub tracks: &'a [Track<'a>],
}

/// Animation of one property of a scene.
#[derive(Clone, Copy, Debug)]
pub struct Track<'a> {
    /// Property that the track animates.
    pub target: Target,
    /// Method of interpolation between the keyframes of the track.
    pub interpolation: Interpolation,
    /// Keyframes of the track in order of time, at least one and at most 65,535. Before the first
    /// keyframe, the property has the value of the first keyframe. After the last keyframe, the
    /// property has the value of the last keyframe.
    pub keys: &'a [Keyframe],
}

/// A property of a scene that a track animates. Objects and lights are numbered from 0.
///
/// Every value that a track reaches must be in the range of its property. A smooth track also
/// reaches values beyond its keyframes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Target {
    /// Position of the camera: [`Camera::eye`](crate::Camera::eye).
    CameraEye,
    /// Point that the camera looks at: [`Camera::look_at`](crate::Camera::look_at).
    CameraLookAt,
    /// Vertical field of view of the camera in degrees:
    /// [`Camera::fovy_deg`](crate::Camera::fovy_deg).
    CameraFovy,
    /// Yaw and pitch, in degrees, that the animation passes to
    /// [`Camera::orbited`](crate::Camera::orbited). This orbit applies to the camera that results
    /// from the other camera tracks.
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

impl Target {
    /// Returns the two numbers that stand for the target in a compiled scene: its kind, and the
    /// number of the object or light.
    pub(super) fn code(self) -> (u8, u16) {
        match self {
            Self::CameraEye => (0, 0),
            Self::CameraLookAt => (1, 0),
            Self::CameraFovy => (2, 0),
            Self::CameraOrbit => (3, 0),
            Self::ObjectPosition(index) => (4, index),
            Self::ObjectRadius(index) => (5, index),
            Self::LightPosition(index) => (6, index),
            Self::LightColor(index) => (7, index),
        }
    }

    /// Returns the target that two numbers in a compiled scene stand for.
    pub(super) fn of_code(kind: u8, index: u16) -> Option<Self> {
        Some(match kind {
            0 => Self::CameraEye,
            1 => Self::CameraLookAt,
            2 => Self::CameraFovy,
            3 => Self::CameraOrbit,
            4 => Self::ObjectPosition(index),
            5 => Self::ObjectRadius(index),
            6 => Self::LightPosition(index),
            7 => Self::LightColor(index),
            _ => return None,
        })
    }

    /// Returns the number of the object that the target belongs to, if it belongs to an object.
    pub(super) fn object(self) -> Option<u16> {
        match self {
            Self::ObjectPosition(index) | Self::ObjectRadius(index) => Some(index),
            _ => None,
        }
    }
}
