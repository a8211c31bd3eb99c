use fixed::types::I8F56;

use crate::math::outlined::{inverse_length, to_bits};
use crate::math::{
    InverseLength, Length, Square, Unit, Vec3, high, normalize, quotient, square_root,
};

/// A sphere around all of a finite shape.
///
/// Most rays pass most shapes by. Whether one does is told by products of 16
/// bits, which every core has; what is left is looked at closely.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BoundingSphere {
    pub(crate) center: Vec3<Length>,
    pub(crate) radius: Length,
}

impl BoundingSphere {
    /// How a near point sees it, an object's.
    pub(crate) fn seen_from(&self, point: Vec3<Length>, object: u16) -> LightCone {
        /// More than what rounding the two directions does to their cosine: 12.6 * 2^-16.
        const MARGIN: i32 = 13 << 14;
        let mut sight = LightCone {
            object,
            ..LightCone::NONE
        };
        let to_center = self.center - point;
        let square = to_center.squared();
        let tangent_squared = square - self.radius.square();
        if tangent_squared > 0 {
            // Q56 -> Q28
            let root = |square: I8F56| u64::from(square_root(square.to_bits() as u64));
            let cosine = to_bits(quotient(root(tangent_squared).max(1), root(square)));
            sight.least = cosine as i32 - MARGIN;
            // Q30 -> Q14, rounded
            let inverse = inverse_length(square.to_bits() as u64);
            let away = -normalize(to_center.map(Length::to_bits), inverse);
            sight.away = away.map(|c| ((c.to_bits() + (1 << 15)) >> 16) as i16);
        }
        sight
    }

    /// For rays from anywhere, of an object.
    pub(crate) fn around(&self, object: u16) -> CullSphere {
        let center = self
            .center
            .map(|c| ((c.to_bits() + (1 << 15)) >> 16) as i16);
        CullSphere::new(center, self.radius + MOVED, object)
    }
}

/// More than a difference moves as one point is rounded to Q12 and another down to it:
/// `sqrt(3) * 1.5 * 2^-12`.
const MOVED: Length = Length::lit("0.00065");

/// A direction for products of 16 bits: Q16, rounded down.
#[inline(always)]
pub(crate) fn narrow(direction: Vec3<Unit>) -> Vec3<i32> {
    direction.map(|c| c.to_bits() >> 14)
}

/// The same of a vector, given the reciprocal of its length; each component within
/// 2^-13.
#[inline(always)]
pub(crate) fn narrowed(v: Vec3<i32>, inverse: InverseLength) -> Vec3<i32> {
    // As `normalize` does it, by the upper halves of what is 2^30 to 2^31 long and of
    // U1F31.
    let shift = inverse.half_shift.wrapping_sub(1) & 31;
    let half = (inverse.inverse >> 16) as i32;
    v.map(|c| ((c << shift >> 16) * half) >> 14)
}

/// A point for differences of 16 bits: Q12, rounded down.
#[inline(always)]
pub(crate) fn coarse(point: Vec3<Length>) -> Vec3<i32> {
    point.map(|c| c.to_bits() >> 16)
}

/// The dot product of vectors whose lengths have a product below 2^31.
#[inline(always)]
fn dot(a: Vec3<i32>, b: Vec3<i32>) -> i32 {
    let Vec3 { x, y, z } = a.zip(b, i32::wrapping_mul);
    x.wrapping_add(y).wrapping_add(z)
}

/// An object's bound as seen from a point where many rays start: a cone.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightCone {
    /// From the center to the point: Q14.
    away: Vec3<i16>,
    /// The object's number.
    pub(crate) object: u16,
    /// The cosine, at least, between that and the opposite of a ray that may meet
    /// the bound: Q30.
    least: i32,
}

impl LightCone {
    /// From within the bound, or before it is computed: any ray may meet it.
    pub(crate) const NONE: Self = Self {
        away: Vec3::new(0, 0, 0),
        object: 0,
        least: 0,
    };

    /// Whether the object may be on the way to the point from a direction, which is
    /// [`narrowed`].
    #[inline(always)]
    pub(crate) fn may_meet(&self, direction: Vec3<i32>) -> bool {
        dot(self.away.map(i32::from), direction) >= self.least
    }
}

/// The bound of an object, for rays from anywhere.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CullSphere {
    /// Q12.
    center: Vec3<i16>,
    /// The object's number.
    pub(crate) object: u16,
    /// Around that center.
    radius: Length,
    /// The square of the radius: Q24, rounded up by what the high words leave out.
    reach: i32,
}

impl CullSphere {
    fn new(center: Vec3<i16>, radius: Length, object: u16) -> Self {
        Self {
            center,
            object,
            radius,
            reach: high(radius.square().to_bits()) + 4,
        }
    }

    /// The bound itself, a little larger.
    pub(crate) fn bound(&self) -> BoundingSphere {
        BoundingSphere {
            center: self.center.map(|c| Length::from_bits(i32::from(c) << 16)),
            radius: self.radius,
        }
    }

    /// The square of how far another center is away: Q24.
    pub(crate) fn squared_to(&self, other: &Self) -> i32 {
        let way = self
            .center
            .zip(other.center, |a, b| i32::from(a) - i32::from(b));
        dot(way, way)
    }

    /// Around all of a group, from the middle of their centers, and of no object.
    pub(crate) fn all(group: &[Self]) -> Self {
        let mut sum = Vec3::new(0, 0, 0);
        for member in group {
            sum = sum + member.center.map(i32::from);
        }
        let count = group.len().max(1) as i32;
        let center = sum.map(|c| c.wrapping_div(count) as i16);
        let middle = Self::new(center, Length::ZERO, u16::MAX);
        let mut radius = Length::ZERO;
        for member in group {
            // Q24 -> Q56 -> Q28
            let square = middle.squared_to(member) as u64;
            let distance = Length::from_bits(square_root(square << 32) as i32);
            radius = radius.max(distance + member.radius);
        }
        Self::new(center, radius + Length::DELTA, u16::MAX)
    }

    /// Whether a ray from a near origin may meet the shape ahead: the origin is
    /// [`coarse`], the direction [`narrow`].
    #[inline(always)]
    pub(crate) fn may_meet(&self, origin: Vec3<i32>, direction: Vec3<i32>) -> bool {
        // Below 8 in length.
        let to_center = self.center.zip(origin, |c, o| i32::from(c) - o);
        let square = dot(to_center, to_center);
        let middle = dot(to_center, direction);
        if middle <= 0 {
            return square <= self.reach;
        }
        // Q28, whose square is Q56 -> Q24. What rounding the direction does to it is less
        // than 2^-14 of the square of the whole.
        square - (square >> 14) - high(middle.square()) <= self.reach
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use fastrand::Rng;
    use std::println;

    use super::*;
    use crate::math::vector;

    fn point(random: &mut Rng, reach: f64) -> Vec3<Length> {
        let mut c = || Length::from_num((2.0 * random.f64() - 1.0) * reach);
        Vec3::new(c(), c(), c())
    }

    fn exact(v: Vec3<Length>) -> [f64; 3] {
        [v.x, v.y, v.z].map(|c| c.to_num())
    }

    /// How near the line from an origin comes to the center of a bound, and how far along
    /// it.
    fn passes(bound: &BoundingSphere, origin: Vec3<Length>, direction: Vec3<Unit>) -> [f64; 2] {
        let (to, d) = (exact(bound.center - origin), direction);
        let d = [d.x, d.y, d.z].map(|c| c.to_num::<f64>());
        let along: f64 = to.iter().zip(d).map(|(c, d)| c * d).sum();
        let off = to.iter().zip(d).map(|(c, d)| (c - along * d).powi(2));
        [off.sum::<f64>().sqrt(), along]
    }

    /// Rays that touch a bound, just miss it, or do neither, from near and far.
    #[test]
    fn no_ray_that_meets_a_bound_is_passed_over() {
        let random = &mut Rng::with_seed(1);
        let (mut met, mut passed, mut in_vain) = (0, 0, 0);
        let rays = if cfg!(miri) { 300 } else { 300_000 };
        for _ in 0..rays {
            let radius = 10_f64.powf(-4.0 * random.f64());
            let bound = BoundingSphere {
                center: point(random, 1.0),
                radius: Length::from_num(radius),
            };
            let reach = [1.0, 3.5][random.usize(..2)];
            let mut origin = point(random, reach);
            if random.bool() {
                origin = bound.center + point(random, 3.0 * radius);
            }
            // Towards somewhere near, or just within where the bound ends.
            let mut side = point(random, radius * 1.5);
            if random.bool() {
                let [x, y, z] = exact(bound.center - origin);
                let [u, v, w] = exact(point(random, 1.0));
                let across = [y * w - z * v, z * u - x * w, x * v - y * u];
                let length = across.iter().map(|c| c * c).sum::<f64>().sqrt();
                let rim = across.map(|c| Length::from_num(c / length * radius * 0.999));
                side = Vec3::new(rim[0], rim[1], rim[2]);
            }
            let towards = bound.center + side;
            let way = (towards - origin).map(|c| i64::from(c.to_bits()));
            let Some(direction) = vector::direction(way) else {
                continue;
            };
            let [off, along] = passes(&bound, origin, direction);
            let from_inside = exact(bound.center - origin)
                .map(|c| c * c)
                .iter()
                .sum::<f64>()
                <= radius * radius;
            let meets = off <= radius && (along > 0.0 || from_inside);
            let around = bound.around(0);
            let sight = bound.seen_from(origin, 0);
            let around = around.may_meet(coarse(origin), narrow(direction));
            let back = origin - towards;
            let sight = sight.may_meet(narrowed(back.map(Length::to_bits), back.normalized().1));
            assert!(!meets || around, "{bound:?} {origin:?} {direction:?}");
            assert!(!meets || sight, "{bound:?} {origin:?} {direction:?}");
            met += i32::from(meets);
            passed += i32::from(!around || !sight);
            in_vain += i32::from(around && sight && !meets);
        }
        println!("{met} bounds met, {passed} passed by, {in_vain} looked at in vain");
        assert!(3 * met > rays && 10 * passed > rays);
    }

    #[test]
    fn no_ray_that_meets_a_bound_passes_over_its_group() {
        let random = &mut Rng::with_seed(2);
        let (mut met, mut passed) = (0, 0);
        for _ in 0..if cfg!(miri) { 300 } else { 30_000 } {
            let (middle, spread) = (point(random, 0.8), 10_f64.powf(-3.0 * random.f64()));
            let radius = Length::from_num(0.1 * spread * random.f64());
            let bounds = [(); 2].map(|()| BoundingSphere {
                center: middle + point(random, 0.2 * spread),
                radius,
            });
            let group = CullSphere::all(&bounds.map(|bound| bound.around(0)));
            let origin = point(random, 3.5);
            // Towards somewhere near, or to just within the far end of one.
            let mut towards = middle + point(random, 0.5 * spread);
            if random.bool() {
                let [one, other] = bounds.map(|bound| bound.center);
                let Some(away) = vector::direction((one - other).map(|c| c.to_bits().into()))
                else {
                    continue;
                };
                towards = one + away.times(radius - (radius >> 7));
            }
            let way = (towards - origin).map(|c| i64::from(c.to_bits()));
            let Some(direction) = vector::direction(way) else {
                continue;
            };
            let may_meet = group.may_meet(coarse(origin), narrow(direction));
            let meets = bounds.iter().any(|bound| {
                let [off, along] = passes(bound, origin, direction);
                off <= bound.radius.to_num::<f64>() && along > 0.0
            });
            assert!(!meets || may_meet, "{bounds:?} {origin:?} {direction:?}");
            met += i32::from(meets);
            passed += i32::from(!may_meet);
        }
        assert!(
            5 * met > passed && 5 * passed > met,
            "{met} met, {passed} passed by"
        );
    }
}
