//! Keyframes and the interpolation between them. The arithmetic uses saturating `I32F32` fixed
//! point.

use super::AnimationProblem;
use crate::math::{Real, Vec3, divide, multiply};

/// Value of an animated property at a given time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keyframe {
    /// Time in seconds. The time must be from 0 to the animation's duration. It must not be
    /// earlier than the time of the previous keyframe.
    ///
    /// Two keyframes may have the same time. If their values differ, the property jumps from
    /// the first value to the second. If their values are equal, a smooth curve gets a corner
    /// at that time. An example is the path of a ball that bounces.
    pub time: Real,
    /// Value of the property at this time. A point or a color uses x, y and z. An orbit uses x
    /// for the yaw and y for the pitch. A plain number uses x only.
    pub value: Vec3<Real>,
}

impl Keyframe {
    /// Returns a keyframe for a point or a color.
    ///
    /// ```
    /// use whitted::animation::Keyframe;
    /// use whitted::{real, vec3};
    ///
    /// let top = Keyframe::vector(real!(0.5), vec3!(0, 2, 0));
    /// assert_eq!(top.value.y, real!(2));
    /// ```
    pub const fn vector(time: Real, value: Vec3<Real>) -> Self {
        Self { time, value }
    }

    /// Returns a keyframe for an orbit, with angles in degrees.
    pub const fn angles(time: Real, yaw_deg: Real, pitch_deg: Real) -> Self {
        Self::vector(time, Vec3::new(yaw_deg, pitch_deg, Real::ZERO))
    }

    /// Returns a keyframe for a plain number.
    pub const fn number(time: Real, number: Real) -> Self {
        Self::vector(time, Vec3::new(number, Real::ZERO, Real::ZERO))
    }
}

/// Method of interpolation between keyframes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// Linear interpolation. The speed changes abruptly at keyframes.
    #[default]
    Linear,
    /// Cubic spline through the keyframes with continuous speed (Catmull and Rom 1974).
    ///
    /// The slope at a keyframe is the slope of a parabola through this keyframe and its two
    /// neighbors (Overhauser 1968). The method works for any spacing of the keyframes in time.
    /// The first and last segments of the spline are parabolas. Three keyframes therefore give
    /// a single parabola, such as the path of a thrown object.
    ///
    /// In a repeating animation, the curve can also be smooth at the time where the animation
    /// starts over. For this, the first keyframe must be at time 0 and the last at `duration`,
    /// and their values must be equal.
    Smooth,
}

/// Checks that the times of keyframes are in order and within the duration of the animation.
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

/// Returns the interpolated value at `time`, or zero if there are no keyframes. `period` is the
/// duration of a repeating animation. It is `None` if the animation does not repeat.
pub(super) fn value(
    keys: &[Keyframe],
    interpolation: Interpolation,
    period: Option<Real>,
    time: Real,
) -> Vec3<Real> {
    // If two keyframes have exactly this time, the value of the second one applies.
    let next = keys.partition_point(|key| key.time <= time);
    let from = next.checked_sub(1).and_then(|last| keys.get(last));
    match (from, keys.get(next)) {
        (Some(from), Some(to)) => {
            let segment = Segment::new(from, to);
            let part = ratio(time - from.time, segment.span);
            let moved = match interpolation {
                Interpolation::Linear => segment.change.map(|c| multiply(c, part)),
                Interpolation::Smooth => segment.smooth(neighbors(keys, next, period), part),
            };
            from.value.zip(moved, Real::saturating_add)
        }
        (Some(end), None) | (None, Some(end)) => end.value,
        (None, None) => Vec3::new(Real::ZERO, Real::ZERO, Real::ZERO),
    }
}

/// The interval between two consecutive keyframes that have different times.
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

    /// Evaluates the spline after the fraction `part` of this segment's time. Returns the value
    /// there minus the value at the start of the segment. `before` and `after` are the
    /// keyframes next to the segment.
    fn smooth(&self, [before, after]: [Option<Keyframe>; 2], part: Real) -> Vec3<Real> {
        let first = before.and_then(|before| self.slope(&Segment::new(&before, self.from)));
        let last = after.and_then(|after| self.slope(&Segment::new(self.to, &after)));
        let (first, last) = match (first, last) {
            (Some(first), Some(last)) => (first, last),
            (Some(first), None) => (first, self.opposite(first)),
            (None, Some(last)) => (self.opposite(last), last),
            (None, None) => return self.change.map(|c| multiply(c, part)),
        };
        let ends = first.zip(last, |first, last| (first, last));
        self.change.zip(ends, |change, (first, last)| {
            hermite(change, first, last, part)
        })
    }

    /// Returns the slope of the spline at the keyframe that this segment shares with
    /// `neighbor`. It is the slope of a parabola through the keyframes of both segments. The
    /// slope is measured as the change of the value over the time of this segment. Returns
    /// `None` if the two keyframes of `neighbor` have the same time.
    #[inline(never)]
    fn slope(&self, neighbor: &Segment<'_>) -> Option<Vec3<Real>> {
        if neighbor.span == 0 {
            return None;
        }
        let weight = ratio(neighbor.span, neighbor.span.saturating_add(self.span));
        let stretch = multiply(ratio(self.span, neighbor.span), Real::ONE - weight);
        Some(self.change.zip(neighbor.change, |change, other| {
            multiply(change, weight).saturating_add(multiply(other, stretch))
        }))
    }

    /// Returns the slope at one end of the segment if the curve is a parabola. The argument
    /// `slope` is the slope at the other end.
    fn opposite(&self, slope: Vec3<Real>) -> Vec3<Real> {
        self.change.zip(slope, |change, slope| {
            change.saturating_add(change).saturating_sub(slope)
        })
    }
}

/// Returns the keyframe before and the keyframe after the segment that ends at keyframe `next`.
fn neighbors(keys: &[Keyframe], next: usize, period: Option<Real>) -> [Option<Keyframe>; 2] {
    let wrapped = period.and_then(|period| wrapped_ends(keys, period));
    let [last, first] = wrapped.unwrap_or([None, None]);
    let before = next.checked_sub(2).and_then(|index| keys.get(index));
    let after = keys.get(next + 1);
    [before.copied().or(last), after.copied().or(first)]
}

/// Returns the two keyframes that continue a repeating track beyond its ends. One is the
/// next-to-last keyframe of the track, moved one period back. The other is the second keyframe
/// of the track, moved one period forward. Returns `None` unless the track begins at time 0,
/// ends at `period`, and has equal values at both times.
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

/// Evaluates a cubic curve after the fraction `part` of its interval. Returns the difference
/// between the value there and the value at the start. The curve rises by `change` over the
/// whole interval and has the slopes `first` and `last` at its ends. The result is exact at
/// both ends.
#[inline(never)]
fn hermite(change: Real, first: Real, last: Real, part: Real) -> Real {
    // If the curve is a straight line, `first` and `last` equal `change`, so both bends are
    // zero.
    let (first_bend, last_bend) = (change.saturating_sub(first), change.saturating_sub(last));
    let square = first_bend
        .saturating_add(first_bend)
        .saturating_add(last_bend);
    let cube = first_bend.saturating_add(last_bend).saturating_neg();
    let bent = multiply(cube, part).saturating_add(square);
    let bent = multiply(bent, part).saturating_add(first);
    multiply(bent, part)
}

/// Returns `dividend / divisor`, rounded toward zero and saturated. Returns 0 if `divisor` is
/// 0.
fn ratio(dividend: Real, divisor: Real) -> Real {
    let quotient = divide(i128::from(dividend.to_bits()) << 32, divisor.to_bits());
    Real::from_bits(quotient.min(i64::MAX.into()) as i64)
}
