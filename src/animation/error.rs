use core::fmt;

/// Why an animation cannot be: which track, and what is wrong with it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct AnimationError {
    /// The track, numbered from 0; `None` if the animation as a whole is meant.
    pub track: Option<u16>,
    /// What is wrong with it.
    pub problem: AnimationProblem,
}

/// What is wrong with an animation. Keys are numbered from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum AnimationProblem {
    /// The duration is not above 0, or beyond 2^24 seconds.
    Duration,
    /// A track has no key.
    NoKeys,
    /// A key is before the one that it follows.
    Unsorted(u16),
    /// More than two keys have one time.
    Crowded(u16),
    /// A key is before the start or beyond the duration.
    OutsideDuration(u16),
    /// The scene has no object of this number.
    NoSuchObject(u16),
    /// The object of this number has no radius.
    NoRadius(u16),
    /// The scene has no light of this number.
    NoSuchLight(u16),
    /// The scene has more objects than the stage has room for.
    TooManyObjects,
    /// The scene has more lights than the stage has room for.
    TooManyLights,
}

impl AnimationProblem {
    pub(super) fn of(self, track: u16) -> AnimationError {
        AnimationError {
            track: Some(track),
            problem: self,
        }
    }

    pub(super) fn of_all(self) -> AnimationError {
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
            Self::Duration => f.write_str("the duration must be above 0, at most 16777216 seconds"),
            Self::NoKeys => f.write_str("there must be at least one key"),
            Self::Unsorted(key) => write!(f, "key {key} must not be before the one above it"),
            Self::Crowded(key) => write!(f, "key {key} is the third of its time"),
            Self::OutsideDuration(key) => {
                write!(f, "key {key} must be from 0 to the duration")
            }
            Self::NoSuchObject(number) => write!(f, "moves object {number}, which is not there"),
            Self::NoRadius(number) => write!(f, "object {number} has no radius"),
            Self::NoSuchLight(number) => write!(f, "moves light {number}, which is not there"),
            Self::TooManyObjects => f.write_str("more objects than the stage has room for"),
            Self::TooManyLights => f.write_str("more lights than the stage has room for"),
        }
    }
}

impl core::error::Error for AnimationError {}
