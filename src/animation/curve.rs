//! The value of a track over time. The arithmetic uses saturating `I32F32` fixed point.

use super::keys::Keys;
use super::segment::{Segment, ratio};
use super::{Interpolation, Keyframe};
use crate::geometry::Extent;
use crate::math::{Real, Vec3};

/// The curve that a value follows over time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Curve<'a> {
    pub(super) keys: Keys<'a>,
    pub(super) interpolation: Interpolation,
    /// Duration of a repeating animation, or `None` if the animation does not repeat.
    pub(super) period: Option<Real>,
}

impl Curve<'_> {
    /// Returns the interpolated value at `time`, or zero if there are no keyframes.
    pub(super) fn value(&self, time: Real) -> Vec3<Real> {
        // If two keyframes have exactly this time, the value of the second one applies.
        let next = self.keys.count_until(time);
        let from = next.checked_sub(1).and_then(|last| self.keys.get(last));
        match (from, self.keys.get(next)) {
            (Some(from), Some(to)) => {
                let segment = self.segment(from, to, next);
                segment.at(ratio(time - from.time, segment.span()))
            }
            (Some(end), None) | (None, Some(end)) => end.value,
            (None, None) => Vec3::new(Real::ZERO, Real::ZERO, Real::ZERO),
        }
    }

    /// Returns a box for each keyframe. Together, the boxes enclose all values of the curve. A box
    /// contains the value of its keyframe and, if the curve turns before the next keyframe, the
    /// values there.
    pub(super) fn reaches(&self) -> impl Iterator<Item = Extent> {
        self.keys.iter().zip(1..).map(|(from, next)| {
            let mut extent = Extent::new(from.value);
            if let Some(to) = self.keys.get(next).filter(|to| to.time > from.time) {
                self.segment(from, to, next).extend(&mut extent);
            }
            extent
        })
    }

    /// Returns the segment from keyframe `next - 1` to keyframe `next`, which are also given.
    fn segment(&self, from: Keyframe, to: Keyframe, next: usize) -> Segment {
        match self.interpolation {
            Interpolation::Linear => Segment::linear(from, to),
            Interpolation::Smooth => Segment::smooth(from, to, self.neighbors(next)),
        }
    }

    /// Returns the keyframe before and the keyframe after the segment that ends at keyframe `next`.
    fn neighbors(&self, next: usize) -> [Option<Keyframe>; 2] {
        let [last, first] = self.wrapped_ends().unwrap_or([None, None]);
        let before = next.checked_sub(2).and_then(|index| self.keys.get(index));
        let after = self.keys.get(next + 1);
        [before.or(last), after.or(first)]
    }

    /// Returns the two keyframes that continue a repeating track beyond its ends. One is the
    /// next-to-last keyframe of the track, moved one period back. The other is the second keyframe
    /// of the track, moved one period forward. Returns `None` unless the track begins at time 0,
    /// ends at the end of the period, and has equal values at both times.
    fn wrapped_ends(&self) -> Option<[Option<Keyframe>; 2]> {
        let (keys, period) = (self.keys, self.period?);
        let (first, last) = (keys.get(0)?, keys.get(keys.len() - 1)?);
        if first.value != last.value || first.time != 0 || last.time != period {
            return None;
        }
        let shifted = |key: Keyframe, by: Real| Keyframe {
            time: key.time.saturating_add(by),
            ..key
        };
        let before = keys.len().checked_sub(2).and_then(|index| keys.get(index));
        Some([
            before.map(|key| shifted(key, -period)),
            keys.get(1).map(|key| shifted(key, period)),
        ])
    }
}
