use core::fmt;

use crate::scene::SceneError;

/// The reason why an animated scene cannot be prepared. It consists of a track and the problem of
/// that track.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AnimationError {
    /// Number of the track, counted from 0. `None` if the problem concerns the whole animation.
    pub track: Option<u16>,
    /// Problem of the track or the animation.
    pub problem: AnimationProblem,
}

/// A problem of an animation. Keyframes are numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum AnimationProblem {
    /// The duration of the animation is not above 0, or exceeds 2^24 seconds.
    Duration,
    /// The track has no keyframe.
    NoKeys,
    /// The keyframe with this number is earlier than the keyframe before it.
    Unsorted(u16),
    /// The keyframe with this number has the same time as the two keyframes before it. Only two
    /// keyframes may share a time.
    Crowded(u16),
    /// The time of the keyframe with this number is negative or exceeds the duration of the
    /// animation.
    OutsideDuration(u16),
    /// The scene has no object with this number.
    NoSuchObject(u16),
    /// The object with this number has no radius.
    NoRadius(u16),
    /// The scene has no light with this number.
    NoSuchLight(u16),
    /// A value is invalid, at the keyframe with this number or between this keyframe and the
    /// next. A smooth track also reaches values beyond its keyframes.
    Value(u16, SceneError),
    /// The scene before animation cannot be prepared.
    Scene(SceneError),
    /// The track has more than 65,535 keyframes.
    TooManyKeys,
    /// The animation has more than 65,535 tracks.
    TooManyTracks,
}

impl AnimationProblem {
    /// Returns an error that names the track.
    pub(super) fn in_track(self, track: u16) -> AnimationError {
        AnimationError {
            track: Some(track),
            problem: self,
        }
    }

    /// Returns an error that concerns the whole animation.
    pub(super) fn in_animation(self) -> AnimationError {
        AnimationError {
            track: None,
            problem: self,
        }
    }
}

impl fmt::Display for AnimationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.track {
            Some(track) => write!(f, "track {track}: {}", self.problem),
            None => write!(f, "animation: {}", self.problem),
        }
    }
}

impl fmt::Display for AnimationProblem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Duration => {
                f.write_str("the duration must be above 0 and at most 16777216 seconds")
            }
            Self::NoKeys => f.write_str("the track needs at least one keyframe"),
            Self::Unsorted(key) => {
                write!(f, "keyframe {key} is earlier than its predecessor")
            }
            Self::Crowded(key) => write!(
                f,
                "three keyframes share a time: remove keyframe {key}, or another of them"
            ),
            Self::OutsideDuration(key) => write!(
                f,
                "the time of keyframe {key} must be from 0 to the duration"
            ),
            Self::NoSuchObject(number) => {
                write!(f, "refers to object {number}, which the scene lacks")
            }
            Self::NoRadius(number) => {
                write!(f, "animates the radius of object {number}, which has none")
            }
            Self::NoSuchLight(number) => {
                write!(f, "refers to light {number}, which the scene lacks")
            }
            Self::Value(key, error) => write!(f, "keyframe {key}: {error}"),
            Self::Scene(error) => error.fmt(f),
            Self::TooManyKeys => f.write_str("the track has more than 65535 keyframes"),
            Self::TooManyTracks => f.write_str("the animation has more than 65535 tracks"),
        }
    }
}

impl core::error::Error for AnimationError {}

impl From<SceneError> for AnimationError {
    fn from(error: SceneError) -> Self {
        AnimationProblem::Scene(error).in_animation()
    }
}
