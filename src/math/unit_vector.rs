//! Products and normalization of vectors whose components are [`Unit`]s.

use fixed::types::I4F60;
use long_multiply::rounded;

use super::format::{Length, Unit};
use super::inverse_length::{inverse_length, inverse_length_outlined};
use super::product::{Product, Square};
use super::scale::{normalize, scaled};
use super::vec3::Vec3;
use super::word::{bits, round_unit};

impl Vec3<Unit> {
    /// Returns the exact dot product of two directions: `I2F30 * I2F30 -> I4F60`.
    pub(crate) fn dot(self, other: Self) -> I4F60 {
        self.x.product(other.x) + self.y.product(other.y) + self.z.product(other.z)
    }

    /// Returns the exact cross product of two directions. Its components are the raw bits of
    /// `I4F60` numbers.
    pub(crate) fn cross(self, other: Self) -> Vec3<i64> {
        let minor = |p: Unit, q: Unit, r: Unit, s: Unit| (p.product(q) - r.product(s)).to_bits();
        Vec3::new(
            minor(self.y, other.z, self.z, other.y),
            minor(self.z, other.x, self.x, other.z),
            minor(self.x, other.y, self.y, other.x),
        )
    }

    /// Returns the exact squared length of the vector: `I2F30 * I2F30 -> I4F60`.
    fn squared(self) -> I4F60 {
        self.x.square() + self.y.square() + self.z.square()
    }

    /// Returns the cosine between two unit vectors, rounded half up: `I2F30 * I2F30 -> I2F30`.
    pub(crate) fn cosine(self, other: Self) -> Unit {
        round_unit::<30>(self.dot(other).to_bits())
    }

    /// Multiplies a unit vector by a distance. The components of the product are rounded half up:
    /// `I2F30 * I4F28 -> I4F28`.
    pub(crate) fn times(self, distance: Length) -> Vec3<Length> {
        scaled::<30>(self.map(Unit::to_bits), distance.to_bits()).map(Length::from_bits)
    }

    /// Scales a vector to unit length. The vector must be shorter than 2. The components of the
    /// result have a resolution of 2^-30.
    pub(crate) fn unit(self) -> Self {
        let inverse = inverse_length(self.squared().to_bits() as u64);
        normalize(self.map(Unit::to_bits), inverse)
    }

    /// Calls [`unit`](Self::unit) and is not inlined. This saves flash where speed does not matter.
    #[inline(never)]
    pub(crate) fn unit_outlined(self) -> Self {
        let inverse = inverse_length_outlined(self.squared().to_bits() as u64);
        normalize(self.map(Unit::to_bits), inverse)
    }

    /// Scales an almost normalized vector n to unit length by one Newton step, n (3 - n²) / 2.
    ///
    /// The step needs no square root. If the length of n is within 2^-16 of 1, the length of the
    /// result differs from 1 only by rounding errors.
    #[inline]
    pub(crate) fn renormalized(self) -> Self {
        // Rounds the squared length from Q60 to Q30. `excess` is 1 minus the squared length, and is
        // small.
        let square = rounded::<30>(self.squared().to_bits());
        let excess = (1_i32 << 30).wrapping_sub(square);
        self.map(|c| {
            // The component has Q14 after the shift, and its product with `excess` has Q44. A
            // shift by 15 bits halves the product and converts it to Q30.
            let step = (c.to_bits() >> 16)
                .wrapping_mul(excess)
                .wrapping_add(1 << 14)
                >> 15;
            Unit::from_bits(c.to_bits() + step)
        })
    }
}

/// Returns the unit vector in the direction of `v`. The components of `v` may be in any unit, but
/// `v` must be shorter than 2^63 units.
///
/// Returns `None` if the magnitude of every component is below 2^10.
pub(crate) fn direction(v: Vec3<i64>) -> Option<Vec3<Unit>> {
    let most = bits(v.x).max(bits(v.y)).max(bits(v.z));
    if most <= 10 {
        return None;
    }
    // Shifts the vector so that its largest component has 30 bits. Rounding may increase this
    // component to 31 bits.
    let v = if most <= 30 {
        v.map(|c| (c << (30 - most)) as i32)
    } else {
        v.map(|c| (((c >> (most - 31)) + 1) >> 1) as i32)
    };
    let square = v.map(|c| c.square());
    let inverse = inverse_length_outlined((square.x + square.y + square.z) as u64);
    Some(normalize(v, inverse).renormalized())
}
