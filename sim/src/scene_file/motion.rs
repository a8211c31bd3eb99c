use whitted::animation::{Animation, Interpolation, Keyframe, Target, Track};
use whitted::{Real, Scene};

use super::error::LoadError;
use super::file::SceneFile;

/// Room for any scene file that moves.
pub type Stage = whitted::animation::AnimatedScene<256, 16>;

/// The `[animation]` of a scene file.
#[derive(Clone, Debug)]
pub struct Motion {
    /// In seconds.
    pub duration: Real,
    /// Whether it then begins anew.
    pub looping: bool,
    pub(super) moves: Vec<Move>,
}

/// A track with keys of its own.
#[derive(Clone, Debug)]
pub(super) struct Move {
    pub(super) target: Target,
    pub(super) interpolation: Interpolation,
    pub(super) keys: Vec<Keyframe>,
}

impl Move {
    fn track(&self) -> Track<'_> {
        Track {
            target: self.target,
            interpolation: self.interpolation,
            keys: &self.keys,
        }
    }
}

impl Motion {
    /// The camera once around what it looks at, in four seconds.
    pub fn once_around() -> Self {
        Self {
            duration: Real::from(4),
            looping: true,
            moves: vec![Move {
                target: Target::CameraOrbit,
                interpolation: Interpolation::Linear,
                keys: vec![
                    Keyframe::angles("0", "0", "0"),
                    Keyframe::angles("4", "360", "0"),
                ],
            }],
        }
    }

    /// The tracks, for an [`Animation`].
    pub fn tracks(&self) -> Vec<Track<'_>> {
        self.moves.iter().map(Move::track).collect()
    }

    fn with<T>(&self, act: impl FnOnce(&Animation<'_>) -> T) -> T {
        act(&Animation {
            duration: self.duration,
            looping: self.looping,
            tracks: &self.tracks(),
        })
    }
}

impl SceneFile {
    /// The scene as it is at a time, in seconds; without `[animation]` it is still.
    pub fn frame<'s>(&'s self, stage: &'s mut Stage, time: Real) -> Result<Scene<'s>, LoadError> {
        let Some(motion) = &self.animation else {
            return Ok(self.scene());
        };
        motion
            .with(|animation| stage.frame(&self.scene(), animation, time))
            .map_err(|error| self.explain_animation(error))
    }

    pub(super) fn check_animation(&self) -> Result<(), LoadError> {
        let check = |motion: &Motion| motion.with(|animation| animation.check(&self.scene()));
        let checked = self.animation.as_ref().map_or(Ok(()), check);
        checked.map_err(|error| self.explain_animation(error))
    }
}
