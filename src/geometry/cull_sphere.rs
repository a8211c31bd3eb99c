use super::bounding_sphere::BoundingSphere;
use super::low_precision::dot;
use crate::math::{Length, Square, Vec3, high, square_root};

/// The bounding sphere of an object, or of a group of objects, in 16-bit precision: 16 bytes.
///
/// Most rays miss most objects. A test by 32-bit products rejects most of these rays; the
/// rest get the exact test.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CullSphere {
    /// Q12.
    center: Vec3<i16>,
    /// Index of the object; `u16::MAX` for a group.
    pub(crate) object: u16,
    /// Radius around the rounded center.
    radius: Length,
    /// Square of the radius: Q24, rounded up by more than the high words leave out.
    radius_squared: i32,
}

impl CullSphere {
    /// Returns the sphere of one object.
    pub(crate) fn new(bound: &BoundingSphere, object: u16) -> Self {
        /// More than a difference changes if one point is rounded to Q12 and the other is
        /// rounded down to Q12: `sqrt(3) * 1.5 * 2^-12`.
        const ROUNDING: Length = Length::lit("0.00065");
        let center = bound
            .center
            .map(|c| ((c.to_bits() + (1 << 15)) >> 16) as i16);
        Self::with_center(center, bound.radius + ROUNDING, object)
    }

    fn with_center(center: Vec3<i16>, radius: Length, object: u16) -> Self {
        Self {
            center,
            object,
            radius,
            radius_squared: high(radius.square().to_bits()) + 4,
        }
    }

    /// Returns a sphere around a group of spheres, centered at the mean of their centers.
    pub(crate) fn around(group: &[Self]) -> Self {
        let mut sum = Vec3::new(0, 0, 0);
        for member in group {
            sum = sum + member.center.map(i32::from);
        }
        let count = group.len().max(1) as i32;
        let center = sum.map(|c| c.wrapping_div(count) as i16);
        let middle = Self::with_center(center, Length::ZERO, u16::MAX);
        let mut radius = Length::ZERO;
        for member in group {
            // Q24 -> Q56 -> Q28
            let square = middle.distance_squared(member) as u64;
            let distance = Length::from_bits(square_root(square << 32) as i32);
            radius = radius.max(distance + member.radius);
        }
        Self::with_center(center, radius + Length::DELTA, u16::MAX)
    }

    /// Converts back to full precision: slightly larger than the original bounding sphere.
    pub(crate) fn bounding_sphere(&self) -> BoundingSphere {
        BoundingSphere {
            center: self.center.map(|c| Length::from_bits(i32::from(c) << 16)),
            radius: self.radius,
        }
    }

    /// Square of the distance between the centers: Q24.
    pub(crate) fn distance_squared(&self, other: &Self) -> i32 {
        let way = self
            .center
            .zip(other.center, |a, b| i32::from(a) - i32::from(b));
        dot(way, way)
    }

    /// Returns true if a ray from a near origin, Q12, in a direction, Q16, may hit the sphere.
    #[inline(always)]
    pub(crate) fn may_hit(&self, origin: Vec3<i32>, direction: Vec3<i32>) -> bool {
        // Below 8 in length.
        let to_center = self.center.zip(origin, |c, o| i32::from(c) - o);
        let square = dot(to_center, to_center);
        let along = dot(to_center, direction);
        if along <= 0 {
            return square <= self.radius_squared;
        }
        // Q28, whose square is Q56 -> Q24. The rounding of the direction changes the square
        // by less than 2^-14 of the squared distance.
        square - (square >> 14) - high(along.square()) <= self.radius_squared
    }
}
