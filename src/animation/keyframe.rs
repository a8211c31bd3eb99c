//! A value that changes from key to key.

use super::AnimationProblem;
use crate::math::{Real, Vec3};

/// A value at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Keyframe {
    /// In seconds, from 0 to the animation's duration; not before the key before.
    ///
    /// Two keys may have one time: there a value jumps, or its motion, if both have
    /// the same value, gets a corner, as that of a ball does where it bounces.
    pub time: Real,
    /// A point or a color; yaw and pitch in x and y; or a number in x.
    pub value: Vec3<Real>,
}

impl Keyframe {
    /// A point or a color at a time, from decimal literals.
    pub const fn vector(time: &str, x: &str, y: &str, z: &str) -> Self {
        Self {
            time: Real::lit(time),
            value: Vec3::lit(x, y, z),
        }
    }

    /// The angles of an orbit at a time, in degrees, from decimal literals.
    pub const fn angles(time: &str, yaw: &str, pitch: &str) -> Self {
        Self::vector(time, yaw, pitch, "0")
    }

    /// A number at a time, from decimal literals.
    pub const fn number(time: &str, number: &str) -> Self {
        Self::vector(time, number, "0", "0")
    }
}

/// How a value gets from key to key.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Interpolation {
    /// In straight lines, at a speed that changes at the keys.
    #[default]
    Linear,
    /// On a curve through the keys, at a speed that does not jump: a cubic
    /// spline (Catmull and Rom 1974) that has, at each key, the slope of the parabola
    /// through it and its neighbors (Overhauser 1968), so that times may be uneven.
    ///
    /// Between an end and the key next to it the curve is a parabola: three keys are a
    /// throw. The ends of a loop that are alike are neighbors.
    Smooth,
}

/// Checks the times of keys.
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

/// The value at a time; zero without keys. In a loop, `period` is its duration.
pub(super) fn value(
    keys: &[Keyframe],
    interpolation: Interpolation,
    period: Option<Real>,
    time: Real,
) -> Vec3<Real> {
    // Of two keys at this time the second counts.
    let next = keys.partition_point(|key| key.time <= time);
    let from = next.checked_sub(1).and_then(|last| keys.get(last));
    match (from, keys.get(next)) {
        (Some(from), Some(to)) => {
            let segment = Segment::new(from, to);
            let part = ratio(time - from.time, segment.span);
            let moved = match interpolation {
                Interpolation::Linear => segment.way.map(|way| way.saturating_mul(part)),
                Interpolation::Smooth => segment.smooth(neighbors(keys, next, period), part),
            };
            from.value.zip(moved, Real::saturating_add)
        }
        (Some(end), None) | (None, Some(end)) => end.value,
        (None, None) => Vec3::new(Real::ZERO, Real::ZERO, Real::ZERO),
    }
}

/// From a key to the next, which is later.
struct Segment<'k> {
    from: &'k Keyframe,
    to: &'k Keyframe,
    span: Real,
    way: Vec3<Real>,
}

impl<'k> Segment<'k> {
    fn new(from: &'k Keyframe, to: &'k Keyframe) -> Self {
        Self {
            from,
            to,
            span: to.time - from.time,
            way: to.value.zip(from.value, Real::saturating_sub),
        }
    }

    /// How far a cubic has come after a part of the way, between keys before and
    /// after.
    fn smooth(&self, [before, after]: [Option<Keyframe>; 2], part: Real) -> Vec3<Real> {
        let first = before.and_then(|before| self.slope(&Segment::new(&before, self.from)));
        let last = after.and_then(|after| self.slope(&Segment::new(self.to, &after)));
        let (first, last) = match (first, last) {
            (Some(first), Some(last)) => (first, last),
            (Some(first), None) => (first, self.opposite(first)),
            (None, Some(last)) => (self.opposite(last), last),
            (None, None) => return self.way.map(|way| way.saturating_mul(part)),
        };
        let ends = first.zip(last, |first, last| (first, last));
        self.way
            .zip(ends, |way, (first, last)| hermite(way, first, last, part))
    }

    /// The slope of the parabola through this segment and a neighbor where they
    /// meet, as the way that it would lead in this segment's time; `None` at a
    /// doubled key.
    fn slope(&self, neighbor: &Segment<'_>) -> Option<Vec3<Real>> {
        if neighbor.span == 0 {
            return None;
        }
        let weight = ratio(neighbor.span, neighbor.span.saturating_add(self.span));
        let stretch = ratio(self.span, neighbor.span).saturating_mul(Real::ONE - weight);
        Some(self.way.zip(neighbor.way, |way, other| {
            way.saturating_mul(weight)
                .saturating_add(other.saturating_mul(stretch))
        }))
    }

    /// The slope at the other end of a parabola.
    fn opposite(&self, slope: Vec3<Real>) -> Vec3<Real> {
        self.way.zip(slope, |way, slope| {
            way.saturating_add(way).saturating_sub(slope)
        })
    }
}

/// The keys before and after the segment that ends at key `next`.
fn neighbors(keys: &[Keyframe], next: usize, period: Option<Real>) -> [Option<Keyframe>; 2] {
    let around = period.and_then(|period| around(keys, period));
    let [last, first] = around.unwrap_or([None, None]);
    let before = next.checked_sub(2).and_then(|index| keys.get(index));
    let after = keys.get(next + 1);
    [before.copied().or(last), after.copied().or(first)]
}

/// Of a loop whose ends are alike: the key before its first and the one after
/// its last.
fn around(keys: &[Keyframe], period: Real) -> Option<[Option<Keyframe>; 2]> {
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

/// How far a cubic has come after a part of its way, by the slopes at its ends:
/// exact at both.
fn hermite(way: Real, first: Real, last: Real, part: Real) -> Real {
    // way - first and way - last vanish on a straight line.
    let (first_bend, last_bend) = (way.saturating_sub(first), way.saturating_sub(last));
    let square = first_bend
        .saturating_add(first_bend)
        .saturating_add(last_bend);
    let cube = first_bend.saturating_add(last_bend).saturating_neg();
    let bent = cube.saturating_mul(part).saturating_add(square);
    let bent = bent.saturating_mul(part).saturating_add(first);
    bent.saturating_mul(part)
}

/// `dividend / divisor` of times, rounded down.
fn ratio(dividend: Real, divisor: Real) -> Real {
    let quotient = (i128::from(dividend.to_bits()) << 32).checked_div(divisor.to_bits().into());
    Real::from_bits(quotient.unwrap_or(0).min(i64::MAX.into()) as i64)
}
