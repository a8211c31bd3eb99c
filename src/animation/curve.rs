//! A value that changes from key to key.

use super::AnimationProblem;
use crate::{Real, Vec3};

/// A value at a time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Key {
    /// In seconds, from 0 to the animation's duration; not before the key before.
    ///
    /// Two keys may have one time: there a value jumps, or its motion, if both have
    /// the same value, gets a corner, as that of a ball does where it bounces.
    pub time: Real,
    /// A point or a color; yaw and pitch in x and y; or a number in x.
    pub value: Vec3<Real>,
}

impl Key {
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
pub(super) fn check(keys: &[Key], duration: Real) -> Result<(), AnimationProblem> {
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
    keys: &[Key],
    interpolation: Interpolation,
    period: Option<Real>,
    time: Real,
) -> Vec3<Real> {
    // Of two keys at this time the second counts.
    let next = keys.partition_point(|key| key.time <= time);
    let key = |index: usize| keys.get(index).copied();
    let (Some(from), Some(to)) = (next.checked_sub(1).and_then(key), key(next)) else {
        let end = key(next).or(keys.last().copied());
        return end.map_or(Vec3::new(Real::ZERO, Real::ZERO, Real::ZERO), |key| {
            key.value
        });
    };
    let span = to.time - from.time;
    let part = scaled(Real::ONE, time - from.time, span);
    let way = to.value.zip(from.value, Real::saturating_sub);
    if interpolation == Interpolation::Linear {
        let moved = way.map(|way| way.saturating_mul(part));
        return from.value.zip(moved, Real::saturating_add);
    }
    let before = match next.checked_sub(2) {
        Some(index) => key(index),
        None => period.and_then(|period| around(keys, period)?.0),
    };
    let after = match key(next + 1) {
        Some(after) => Some(after),
        None => period.and_then(|period| around(keys, period)?.1),
    };
    // The ways that the slopes at both ends would lead in the whole span.
    let slope = |key: Option<Key>, end: Key| {
        let key = key.filter(|key| key.time != end.time)?;
        let other = (end.time - key.time).abs();
        let across = end.value.zip(key.value, Real::saturating_sub);
        let across = if key.time < end.time {
            across
        } else {
            across.map(Real::saturating_neg)
        };
        Some(way.zip(across, |way, across| {
            let sum = other.saturating_add(span);
            let steep = scaled(scaled(across, span, other), span, sum);
            scaled(way, other, sum).saturating_add(steep)
        }))
    };
    let (first, last) = match (slope(before, from), slope(after, to)) {
        (Some(first), Some(last)) => (first, last),
        (Some(first), None) => (first, opposite(way, first)),
        (None, Some(last)) => (opposite(way, last), last),
        (None, None) => (way, way),
    };
    let ends = first.zip(last, |first, last| (first, last));
    let moved = way.zip(ends, |way, (first, last)| hermite(way, first, last, part));
    from.value.zip(moved, Real::saturating_add)
}

/// The slope at the other end of a parabola.
fn opposite(way: Vec3<Real>, slope: Vec3<Real>) -> Vec3<Real> {
    way.zip(slope, |way, slope| {
        way.saturating_add(way).saturating_sub(slope)
    })
}

/// Of a loop whose ends are alike: the key before its first and the one after
/// its last.
fn around(keys: &[Key], period: Real) -> Option<(Option<Key>, Option<Key>)> {
    let (first, last) = (keys.first()?, keys.last()?);
    if first.value != last.value || first.time != 0 || last.time != period {
        return None;
    }
    let shifted = |key: &Key, by: Real| Key {
        time: key.time.saturating_add(by),
        ..*key
    };
    let before = keys.iter().rev().nth(1).map(|key| shifted(key, -period));
    let after = keys.get(1).map(|key| shifted(key, period));
    Some((before, after))
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

/// `x * dividend / divisor`, rounded towards zero.
fn scaled(x: Real, dividend: Real, divisor: Real) -> Real {
    let product = i128::from(x.to_bits()) * i128::from(dividend.to_bits());
    let quotient = product.checked_div(divisor.to_bits().into()).unwrap_or(0);
    Real::from_bits(quotient.clamp(i64::MIN.into(), i64::MAX.into()) as i64)
}
