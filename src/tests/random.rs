//! Random operands for tests, from seeded generators.

use fastrand::Rng;

use crate::geometry::{OriginSurface, Point, Ray};
use crate::math::{Length, Unit, Vec3, direction};

/// Returns a number between `low` and `high`, evenly distributed.
pub(crate) fn between(random: &mut Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * random.f64()
}

/// Returns a point with coordinates between `-reach` and `reach`.
pub(crate) fn point(random: &mut Rng, reach: f64) -> Vec3<Length> {
    let mut c = || Length::from_num(between(random, -reach, reach));
    Vec3::new(c(), c(), c())
}

/// Returns a unit vector.
pub(crate) fn unit_vector(random: &mut Rng) -> Vec3<Unit> {
    let along = point(random, 1.0).map(|c| c.to_bits().into());
    direction(along).unwrap_or(Vec3::new(Unit::ONE, Unit::ZERO, Unit::ZERO))
}

/// Returns a ray from within 3 towards a point within 0.7 of the origin, in each coordinate.
pub(crate) fn ray(random: &mut Rng) -> Ray {
    let (from, to) = (point(random, 3.0), point(random, 0.7));
    Ray {
        origin: Point::near(from),
        direction: (to - from).normalized().0,
        leaves: OriginSurface::NONE,
    }
}

/// Returns `least`, `most` or a number in between whose magnitude is evenly distributed.
///
/// One in eight numbers each is `least` and `most`.
pub(crate) fn within(random: &mut Rng, least: i64, most: i64) -> i64 {
    let number = match random.u8(..8) {
        0 => least,
        1 => most,
        _ => random.i64(..) >> random.u8(..64),
    };
    number.clamp(least, most)
}

/// Returns 32-bit words: all powers of two, both ends and the middle of each of 64 segments,
/// their neighbors, and a million random words.
pub(crate) fn words() -> impl Iterator<Item = u32> {
    let powers = (0..32).flat_map(|bit| {
        let x = 1_u32 << bit;
        [x, x.wrapping_sub(1), x + 1, !x]
    });
    let segments = (0..64_u32).flat_map(|i| {
        let x = i << 26;
        [x, x.wrapping_sub(1), x + 1, x + (1 << 25)]
    });
    let mut random = Rng::with_seed(1);
    // Miri takes a thousand times as long for each.
    let count = if cfg!(miri) { 200 } else { 1_000_000 };
    let random = (0..count).map(move |_| random.u32(..));
    powers.chain(segments).chain(random)
}

/// Returns a length between `low` and `high`, and its value after rounding.
pub(crate) fn random_length(random: &mut Rng, low: f64, high: f64) -> (Length, f64) {
    let length = Length::from_num(between(random, low, high));
    (length, length.to_num())
}
