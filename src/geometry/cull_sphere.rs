use super::bounding_sphere::BoundingSphere;
use super::low_precision::dot;
use crate::math::{Length, Square, Vec3, high, square_root};

/// The bounding sphere of an object or of a group of objects, stored in 16 bytes with a 16-bit
/// center.
///
/// Most rays miss most objects. A fast test with 32-bit products rejects most of the rays that
/// miss. Only the remaining rays get the exact test.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CullSphere {
    /// Center, rounded to Q12.
    center: Vec3<i16>,
    /// Index of the object, or `u16::MAX` for a group.
    pub(crate) object: u16,
    /// Radius around the rounded center.
    radius: Length,
    /// Square of the radius in Q24. It is rounded up, because the test ignores the low words of
    /// its products.
    radius_squared: i32,
}

impl CullSphere {
    /// Returns the cull sphere of one object.
    pub(crate) fn new(bound: &BoundingSphere, object: u16) -> Self {
        /// Bound of the rounding error of the vector from the origin of a ray to the center.
        /// Along each axis, rounding the center to Q12 changes the vector by up to 0.5 * 2^-12.
        /// Rounding the origin down to Q12 changes it by up to 2^-12. Over three axes, the
        /// length of the error is below `1.5 * sqrt(3) * 2^-12`.
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

    /// Returns a sphere that encloses a group of spheres. Its center is the mean of their
    /// centers.
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
            // The square is shifted from Q24 to Q56, so its root has Q28.
            let square = middle.distance_squared(member) as u64;
            let distance = Length::from_bits(square_root(square << 32) as i32);
            radius = radius.max(distance + member.radius);
        }
        Self::with_center(center, radius + Length::DELTA, u16::MAX)
    }

    /// Converts this sphere to a bounding sphere of full precision. The result is slightly
    /// larger than the original bounding sphere.
    pub(crate) fn bounding_sphere(&self) -> BoundingSphere {
        BoundingSphere {
            center: self.center.map(|c| Length::from_bits(i32::from(c) << 16)),
            radius: self.radius,
        }
    }

    /// Returns the squared distance between the centers of two spheres, in Q24.
    pub(crate) fn distance_squared(&self, other: &Self) -> i32 {
        let way = self
            .center
            .zip(other.center, |a, b| i32::from(a) - i32::from(b));
        dot(way, way)
    }

    /// Returns true if a ray may hit the sphere. The origin has Q12 coordinates and must be in
    /// the near range (each coordinate within ±3.5). The direction is a unit vector in Q16.
    #[inline(always)]
    pub(crate) fn may_hit(&self, origin: Vec3<i32>, direction: Vec3<i32>) -> bool {
        // The distance to the center is below 8, so its square in Q24 fits 32 bits.
        let to_center = self.center.zip(origin, |c, o| i32::from(c) - o);
        let square = dot(to_center, to_center);
        let along = dot(to_center, direction);
        if along <= 0 {
            return square <= self.radius_squared;
        }
        // `along` has Q28. Its square has Q56 and is shifted to Q24. Rounding the direction
        // changes this square by less than 2^-14 of the squared distance to the center. This
        // error is subtracted as a margin.
        square - (square >> 14) - high(along.square()) <= self.radius_squared
    }
}
