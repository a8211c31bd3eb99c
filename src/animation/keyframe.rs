//! Keyframes and the interpolation between them, in `I32F32` with saturation.

use super::AnimationProblem;
use crate::math::{Real, Vec3};

/// Value of a track at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keyframe {
    /// Time in seconds, from 0 to the animation's duration and not before the previous keyframe.
    ///
    /// Two keyframes may share a time. If their values differ, the value jumps. If their values
    /// are equal, a smooth curve gets a corner, like the path of a bouncing ball.
    pub time: Real,
    /// Point or color; or yaw and pitch in x and y; or a number in x.
    pub value: Vec3<Real>,
}

impl Keyframe {
    /// Returns a keyframe for a point or a color, from decimal literals.
    pub const fn vector(time: &str, x: &str, y: &str, z: &str) -> Self {
        Self {
            time: Real::lit(time),
            value: Vec3::lit(x, y, z),
        }
    }

    /// Returns a keyframe for an orbit with angles in degrees, from decimal literals.
    pub const fn angles(time: &str, yaw: &str, pitch: &str) -> Self {
        Self::vector(time, yaw, pitch, "0")
    }

    /// Returns a keyframe for a number, from decimal literals.
    pub const fn number(time: &str, number: &str) -> Self {
        Self::vector(time, number, "0", "0")
    }
}

/// Interpolation between keyframes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// Linear interpolation. The speed jumps at keyframes.
    #[default]
    Linear,
    /// Cubic spline through the keyframes with continuous speed (Catmull and Rom 1974).
    ///
    /// The slope at a keyframe is that of the parabola through the keyframe and its neighbors
    /// (Overhauser 1968), so times need not be evenly spaced. The first and last segments are
    /// parabolas, so three keyframes describe a throw. In a repeating animation whose first and
    /// last keyframes have equal values at times 0 and `duration`, the curve is also smooth where
    /// it repeats.
    Smooth,
}

/// Checks that the times of keyframes are within the duration and in order.
pub(super) fn check(keys: &[Keyframe], duration: Real) -> Result<(), AnimationProblem> {
    if keys.is_empty() {
        return Err(AnimationProblem::NoKeys);
    }
    for (key, index) in keys.iter().zip(0..) {
        if !(Real::ZERO..=duration).contains(&key.time) {
            return Err(AnimationProblem::OutsideDuration(index));
        }
    }
    for (pair, index) in keys.windows(2).zip(1..) {
        if pair.first().map(|key| key.time) > pair.last().map(|key| key.time) {
            return Err(AnimationProblem::Unsorted(index));
        }
    }
    for (three, index) in keys.windows(3).zip(2..) {
        if three.first().map(|key| key.time) == three.last().map(|key| key.time) {
            return Err(AnimationProblem::Crowded(index));
        }
    }
    Ok(())
}

/// Returns the interpolated value at `time`, or zero without keyframes. `period` is the duration
/// of a repeating animation.
pub(super) fn value(
    keys: &[Keyframe],
    interpolation: Interpolation,
    period: Option<Real>,
    time: Real,
) -> Vec3<Real> {
    // If two keyframes share this time, the second one applies.
    let next = keys.partition_point(|key| key.time <= time);
    let from = next.checked_sub(1).and_then(|last| keys.get(last));
    match (from, keys.get(next)) {
        (Some(from), Some(to)) => {
            let segment = Segment::new(from, to);
            let part = ratio(time - from.time, segment.span);
            let moved = match interpolation {
                Interpolation::Linear => segment.change.map(|c| c.saturating_mul(part)),
                Interpolation::Smooth => segment.smooth(neighbors(keys, next, period), part),
            };
            from.value.zip(moved, Real::saturating_add)
        }
        (Some(end), None) | (None, Some(end)) => end.value,
        (None, None) => Vec3::new(Real::ZERO, Real::ZERO, Real::ZERO),
    }
}

/// Interval between two consecutive keyframes of different times.
struct Segment<'k> {
    from: &'k Keyframe,
    to: &'k Keyframe,
    span: Real,
    change: Vec3<Real>,
}

impl<'k> Segment<'k> {
    fn new(from: &'k Keyframe, to: &'k Keyframe) -> Self {
        Self {
            from,
            to,
            span: to.time - from.time,
            change: to.value.zip(from.value, Real::saturating_sub),
        }
    }

    /// Returns the change of the spline from the start of the segment to the fraction `part`, given
    /// the keyframes before and after the segment.
    fn smooth(&self, [before, after]: [Option<Keyframe>; 2], part: Real) -> Vec3<Real> {
        let first = before.and_then(|before| self.slope(&Segment::new(&before, self.from)));
        let last = after.and_then(|after| self.slope(&Segment::new(self.to, &after)));
        let (first, last) = match (first, last) {
            (Some(first), Some(last)) => (first, last),
            (Some(first), None) => (first, self.opposite(first)),
            (None, Some(last)) => (self.opposite(last), last),
            (None, None) => return self.change.map(|c| c.saturating_mul(part)),
        };
        let ends = first.zip(last, |first, last| (first, last));
        self.change.zip(ends, |change, (first, last)| {
            hermite(change, first, last, part)
        })
    }

    /// Returns the slope of the parabola through this segment and a neighbor at their common
    /// keyframe, as the change over this segment's time; `None` if two keyframes share that time.
    fn slope(&self, neighbor: &Segment<'_>) -> Option<Vec3<Real>> {
        if neighbor.span == 0 {
            return None;
        }
        let weight = ratio(neighbor.span, neighbor.span.saturating_add(self.span));
        let stretch = ratio(self.span, neighbor.span).saturating_mul(Real::ONE - weight);
        Some(self.change.zip(neighbor.change, |change, other| {
            change
                .saturating_mul(weight)
                .saturating_add(other.saturating_mul(stretch))
        }))
    }

    /// Returns the slope at the other end of the segment for a parabola with `slope` at one end.
    fn opposite(&self, slope: Vec3<Real>) -> Vec3<Real> {
        self.change.zip(slope, |change, slope| {
            change.saturating_add(change).saturating_sub(slope)
        })
    }
}

/// Returns the keyframes before and after the segment that ends at keyframe `next`.
fn neighbors(keys: &[Keyframe], next: usize, period: Option<Real>) -> [Option<Keyframe>; 2] {
    let wrapped = period.and_then(|period| wrapped_ends(keys, period));
    let [last, first] = wrapped.unwrap_or([None, None]);
    let before = next.checked_sub(2).and_then(|index| keys.get(index));
    let after = keys.get(next + 1);
    [before.copied().or(last), after.copied().or(first)]
}

/// Returns the last-but-one keyframe moved to before the first, and the second keyframe moved to
/// after the last; `None` unless the track ends as it begins, at times 0 and `period`.
fn wrapped_ends(keys: &[Keyframe], period: Real) -> Option<[Option<Keyframe>; 2]> {
    let (first, last) = (keys.first()?, keys.last()?);
    if first.value != last.value || first.time != 0 || last.time != period {
        return None;
    }
    let shifted = |key: &Keyframe, by: Real| Keyframe {
        time: key.time.saturating_add(by),
        ..*key
    };
    let before = keys.iter().rev().nth(1).map(|key| shifted(key, -period));
    let after = keys.get(1).map(|key| shifted(key, period));
    Some([before, after])
}

/// Returns the change of a cubic with the total change `change` after the fraction `part`, given
/// its slopes at both ends. Exact at both ends.
fn hermite(change: Real, first: Real, last: Real, part: Real) -> Real {
    // Both differences are zero on a straight line.
    let (first_bend, last_bend) = (change.saturating_sub(first), change.saturating_sub(last));
    let square = first_bend
        .saturating_add(first_bend)
        .saturating_add(last_bend);
    let cube = first_bend.saturating_add(last_bend).saturating_neg();
    let bent = cube.saturating_mul(part).saturating_add(square);
    let bent = bent.saturating_mul(part).saturating_add(first);
    bent.saturating_mul(part)
}

/// Returns `dividend / divisor`, rounded toward zero and saturated; 0 if `divisor` is 0.
fn ratio(dividend: Real, divisor: Real) -> Real {
    let quotient = (i128::from(dividend.to_bits()) << 32).checked_div(divisor.to_bits().into());
    Real::from_bits(quotient.unwrap_or(0).min(i64::MAX.into()) as i64)
}
