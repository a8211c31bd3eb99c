use super::{AnimationProblem, Keyframe};
use crate::archive::{Fields, Reader};
use crate::math::{Real, Vec3};

/// Size of a keyframe in a compiled scene, in bytes: the time and three coordinates.
const COMPILED_LEN: usize = 4 * size_of::<Real>();

/// The keyframes of a track, either in memory or in the bytes of a compiled scene.
#[derive(Clone, Copy, Debug)]
pub(super) enum Keys<'a> {
    Authored(&'a [Keyframe]),
    Compiled(&'a [[u8; COMPILED_LEN]]),
}

impl<'a> Keys<'a> {
    /// Takes a number of keyframes from the start of `bytes`. Returns `None` if there are fewer.
    pub(super) fn take(bytes: &mut &'a [u8], count: u16) -> Option<Self> {
        let length = usize::from(count) * COMPILED_LEN;
        let (first, rest) = bytes.split_at_checked(length)?;
        *bytes = rest;
        Some(Self::Compiled(first.as_chunks().0))
    }

    pub(super) fn len(&self) -> usize {
        match self {
            Self::Authored(keys) => keys.len(),
            Self::Compiled(keys) => keys.len(),
        }
    }

    /// Returns the keyframe with this number, counted from 0.
    pub(super) fn get(&self, index: usize) -> Option<Keyframe> {
        match self {
            Self::Authored(keys) => keys.get(index).copied(),
            Self::Compiled(keys) => {
                let mut key = Keyframe {
                    time: Real::ZERO,
                    value: Vec3::new(Real::ZERO, Real::ZERO, Real::ZERO),
                };
                key.visit(&mut Reader::new(keys.get(index)?.as_slice()));
                Some(key)
            }
        }
    }

    pub(super) fn iter(self) -> impl Iterator<Item = Keyframe> {
        (0..self.len()).filter_map(move |index| self.get(index))
    }

    /// Returns the number of keyframes that are not later than `time`. The search halves the
    /// range in each step.
    pub(super) fn count_until(&self, time: Real) -> usize {
        let (mut low, mut high) = (0, self.len());
        while low < high {
            let middle = low.midpoint(high);
            if self.get(middle).is_some_and(|key| key.time <= time) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        low
    }

    /// Checks that the times of the keyframes are in order and within the duration of the
    /// animation.
    pub(super) fn check(&self, duration: Real) -> Result<(), AnimationProblem> {
        if u16::try_from(self.len()).is_err() {
            return Err(AnimationProblem::TooManyKeys);
        }
        let mut previous = [None; 2];
        for (key, index) in self.iter().zip(0..=u16::MAX) {
            if !(Real::ZERO..=duration).contains(&key.time) {
                return Err(AnimationProblem::OutsideDuration(index));
            }
            let time = Some(key.time);
            if previous[1] > time {
                return Err(AnimationProblem::Unsorted(index));
            }
            if previous == [time; 2] {
                return Err(AnimationProblem::Crowded(index));
            }
            previous = [previous[1], time];
        }
        match previous[1] {
            Some(_) => Ok(()),
            None => Err(AnimationProblem::NoKeys),
        }
    }
}
