use std::collections::BTreeSet;

use whitted::animation::{Animation, Interpolation, Keyframe, Target, Track};
use whitted::{Real, real};

/// Content of the table `[animation]` of a scene file. This type owns its lists, while an
/// [`Animation`] borrows its lists.
#[derive(Clone, Debug)]
pub struct FileAnimation {
    /// Duration in seconds.
    pub duration: Real,
    /// True if the animation repeats after its duration.
    pub looping: bool,
    pub(super) tracks: Vec<FileTrack>,
}

/// A track with an owned list of keyframes.
#[derive(Clone, Debug)]
pub(super) struct FileTrack {
    pub(super) target: Target,
    pub(super) interpolation: Interpolation,
    pub(super) keys: Vec<Keyframe>,
}

impl FileTrack {
    fn borrow(&self) -> Track<'_> {
        Track {
            target: self.target,
            interpolation: self.interpolation,
            keys: &self.keys,
        }
    }
}

impl FileAnimation {
    /// Returns an animation in which the camera orbits `look_at` once in four seconds.
    pub fn single_orbit() -> Self {
        Self {
            duration: Real::from(4),
            looping: true,
            tracks: vec![FileTrack {
                target: Target::CameraOrbit,
                interpolation: Interpolation::Linear,
                keys: vec![
                    Keyframe::angles(real!(0), real!(0), real!(0)),
                    Keyframe::angles(real!(4), real!(360), real!(0)),
                ],
            }],
        }
    }

    /// Returns the tracks in the form that [`Animation`] borrows.
    pub fn tracks(&self) -> Vec<Track<'_>> {
        self.tracks.iter().map(FileTrack::borrow).collect()
    }

    /// Returns times at which the animation can be checked, sorted: 256 times with equal distances,
    /// and the times of 1024 keyframes of each track or of all of them.
    pub(super) fn sample_times(&self) -> BTreeSet<Real> {
        const DISTANCES: u16 = 256;
        const KEYS: usize = 1024;
        let keys = self.tracks.iter().flat_map(|track| {
            let step = track.keys.len().div_ceil(KEYS).max(1);
            track.keys.iter().step_by(step).map(|key| key.time)
        });
        let distance = self.duration / i64::from(DISTANCES);
        keys.chain((0..DISTANCES).map(|index| distance * i64::from(index)))
            .collect()
    }

    /// Calls a function with this animation as the library's [`Animation`].
    pub(super) fn with_animation<T>(&self, call: impl FnOnce(&Animation<'_>) -> T) -> T {
        call(&Animation {
            duration: self.duration,
            looping: self.looping,
            tracks: &self.tracks(),
        })
    }
}
