//! Rays, and the points along them.

use super::point::{NEAR, Point, are_near};
use super::surface::OriginSurface;
use crate::math::{Length, Product, SoftFloat, Unit, Vec3, round_length, rounded};

/// A ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray {
    pub(crate) origin: Point,
    pub(crate) direction: Vec3<Unit>,
    pub(crate) leaves: OriginSurface,
}

impl Ray {
    /// Returns the point at a distance below 8 along the ray. The origin must be in the near
    /// range (each coordinate within ±3.5).
    pub(crate) fn at(&self, distance: Length) -> Point {
        let coordinates = self.at_near(distance);
        if are_near(coordinates) {
            Point::near(coordinates)
        } else {
            self.at_extended(SoftFloat::unordered(distance))
        }
    }

    /// Returns the coordinates of the point at a distance below 8 along the ray. Both the
    /// origin and the point must be in the near range (each coordinate within ±3.5).
    ///
    /// Outside of the near range, a coordinate can reach 3.5 + 8, which a [`Length`] cannot hold.
    /// The coordinate then wraps around, but its magnitude is still above 4. [`are_near`] therefore
    /// detects such a point.
    #[inline(always)]
    pub(crate) fn at_near(&self, distance: Length) -> Vec3<Length> {
        let origin = self.origin.coordinates;
        origin.zip(self.direction.times(distance), Length::wrapping_add)
    }

    /// Returns the point at any distance along the ray. The origin may be in the near or the
    /// extended range.
    #[cold]
    pub(crate) fn at_extended(&self, distance: SoftFloat) -> Point {
        let origin_shift = i32::from(self.origin.shift);
        // Both terms of the sum use the coarser of two units: the unit of the origin, and the
        // finest unit in which the distance is below 2^30.
        let shift = origin_shift
            .max(distance.exponent + 32 - distance.mantissa.leading_zeros() as i32 - 30);
        let down = (shift - distance.exponent) as u32;
        let shifted = distance.mantissa.unbounded_shr(down) as i32;
        let coordinates = self.origin.coordinates.zip(self.direction, |o, d| {
            i64::from(o.to_bits() >> (shift - origin_shift).min(31))
                + ((d.to_bits().product(shifted) + (1 << 29)) >> 30)
        });
        Point::normalized(coordinates, shift as u32)
    }

    /// Moves the origin of the ray from the extended range to the near range (each coordinate
    /// within ±3.5). The new origin is on the same line, just outside of the bounded geometry. Also
    /// returns the distance from the old origin to the new one, in units of 2^-28.
    ///
    /// Returns `None` if the ray surely misses the bounded geometry or points away from it.
    #[cold]
    pub(crate) fn moved_near(&self) -> Option<(Self, i64)> {
        /// Distance of the new origin from the foot. Bounded geometry is at most sqrt(3) from the
        /// origin of the scene, because its coordinates are within ±1. This distance is larger.
        const START: Length = Length::lit("1.75");
        const LARGEST: i64 = 2 << 58;

        let Point { coordinates, shift } = self.origin;
        let to_foot = -coordinates.along(self.direction).to_bits();
        if to_foot <= 0 {
            return None;
        }
        let to_foot = rounded::<30>(to_foot);
        // The foot is the point of the ray nearest to the origin of the scene. Its coordinates have
        // Q58, and their unit is `2^shift`.
        let foot = coordinates.zip(self.direction, |c, d| {
            (i64::from(c.to_bits()) << 30) + d.to_bits().product(to_foot)
        });
        let is_outside = |c: i64| c.abs() > LARGEST >> shift;
        if is_outside(foot.x) || is_outside(foot.y) || is_outside(foot.z) {
            return None;
        }
        // Shifting by `shift` removes the scale; the coordinates are then rounded from Q58 to
        // Q28.
        let foot = foot.map(|c| round_length::<30>(c << shift));
        let origin = Point::near(foot - self.direction.times(START));
        let skipped = (i64::from(to_foot) << shift) - i64::from(START.to_bits());
        Some((Self { origin, ..*self }, skipped))
    }
}

// If a point in the near range (within ±3.5) moves by up to 8, a coordinate may wrap around. It
// must not wrap into the near range.
const _: () = assert!(NEAR as i64 + (8 << 28) < (1 << 32) - NEAR as i64);
