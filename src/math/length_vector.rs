//! Products and lengths of vectors whose components are [`Length`]s.

use fixed::types::{I6F58, I8F56};

use super::format::{Length, Unit};
use super::inverse_length::{InverseLength, inverse_length};
use super::product::{Product, Square};
use super::scale::normalize;
use super::vec3::Vec3;
use super::word::round_length;

impl Vec3<Length> {
    /// Returns the exact dot product of two vectors: `I4F28 * I4F28 -> I8F56`.
    pub(crate) fn dot(self, other: Self) -> I8F56 {
        self.x.product(other.x) + self.y.product(other.y) + self.z.product(other.z)
    }

    /// Returns the exact component of the vector along a unit vector: `I4F28 * I2F30 -> I6F58`.
    ///
    /// The vector must be shorter than 8.
    #[inline(always)]
    pub(crate) fn along(self, direction: Vec3<Unit>) -> I6F58 {
        self.x.product(direction.x) + self.y.product(direction.y) + self.z.product(direction.z)
    }

    /// Returns the exact squared length of the vector: `I4F28^2 -> I8F56`. The vector must be
    /// shorter than 8.
    #[inline(always)]
    pub(crate) fn squared(self) -> I8F56 {
        self.x.square() + self.y.square() + self.z.square()
    }

    /// Returns the cross product of the vector and a unit vector, rounded half up:
    /// `I4F28 * I2F30 -> I4F28`.
    ///
    /// The vector must be shorter than 8.
    #[inline]
    pub(crate) fn cross(self, direction: Vec3<Unit>) -> Self {
        let minor = |p: Length, q: Unit, r: Length, s: Unit| {
            round_length::<30>((p.product(q) - r.product(s)).to_bits())
        };
        let d = direction;
        Self::new(
            minor(self.y, d.z, self.z, d.y),
            minor(self.z, d.x, self.x, d.z),
            minor(self.x, d.y, self.y, d.x),
        )
    }

    /// Returns the vector scaled to unit length, and the inverse length of the original vector. The
    /// components of the unit vector have a resolution of 2^-30.
    ///
    /// The vector must be shorter than 8. For a zero vector, the result is a zero vector.
    #[inline(always)]
    pub(crate) fn normalized(self) -> (Vec3<Unit>, InverseLength) {
        let inverse = inverse_length(self.squared().to_bits() as u64);
        (normalize(self.map(Length::to_bits), inverse), inverse)
    }
}
