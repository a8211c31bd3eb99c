//! Unit vectors: products in steps of 2^-30, and normalization.

use fixed::types::I4F60;
use long_multiply::rounded;

use super::format::{Length, Unit};
use super::inverse_length::{inverse_length, inverse_length_outlined};
use super::product::{Product, Square};
use super::scale::{normalize, scaled};
use super::vec3::Vec3;
use super::word::{bits, round_unit};

impl Vec3<Unit> {
    /// Returns the dot product of two directions, exact: `I2F30^2 -> I4F60`.
    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> I4F60 {
        self.x.product(other.x) + self.y.product(other.y) + self.z.product(other.z)
    }

    /// Returns the cross product of two directions, exact: `I2F30^2 -> I4F60`, as bits.
    pub(crate) fn cross(self, other: Self) -> Vec3<i64> {
        let minor = |p: Unit, q: Unit, r: Unit, s: Unit| (p.product(q) - r.product(s)).to_bits();
        Vec3::new(
            minor(self.y, other.z, self.z, other.y),
            minor(self.z, other.x, self.x, other.z),
            minor(self.x, other.y, self.y, other.x),
        )
    }

    /// Returns the squared length, exact: `I2F30^2 -> I4F60`.
    #[inline(always)]
    fn squared(self) -> I4F60 {
        self.x.square() + self.y.square() + self.z.square()
    }

    /// Returns the cosine between two unit vectors, rounded half up: `I2F30^2 -> I2F30`.
    #[inline(always)]
    pub(crate) fn cosine(self, other: Self) -> Unit {
        round_unit::<30>(self.dot(other).to_bits())
    }

    /// Returns the vector `distance` long in this direction, rounded half up:
    /// `I2F30 * I4F28 -> I4F28`.
    #[inline(always)]
    pub(crate) fn times(self, distance: Length) -> Vec3<Length> {
        scaled::<30>(self.map(Unit::to_bits), distance.to_bits()).map(Length::from_bits)
    }

    /// Scales a vector shorter than 2 to unit length, each component to 2^-30.
    #[inline(always)]
    pub(crate) fn unit(self) -> Self {
        let inverse = inverse_length(self.squared().to_bits() as u64);
        normalize(self.map(Unit::to_bits), inverse)
    }

    /// Calls [`unit`](Self::unit) out of line, to save flash where speed does not matter.
    #[inline(never)]
    pub(crate) fn unit_outlined(self) -> Self {
        let inverse = inverse_length_outlined(self.squared().to_bits() as u64);
        normalize(self.map(Unit::to_bits), inverse)
    }

    /// Restores unit length by one Newton step, n (3 - n²) / 2.
    ///
    /// Needs no square root. A length within 2^-16 of 1 becomes 1 except for rounding.
    #[inline]
    pub(crate) fn renormalized(self) -> Self {
        // Q60 -> Q30: `excess` has few significant bits.
        let square = rounded::<30>(self.squared().to_bits());
        let excess = (1_i32 << 30).wrapping_sub(square);
        self.map(|c| {
            // Q14 * Q30 -> Q44, halved -> Q30
            let step = (c.to_bits() >> 16)
                .wrapping_mul(excess)
                .wrapping_add(1 << 14)
                >> 15;
            Unit::from_bits(c.to_bits() + step)
        })
    }
}

/// Returns the unit vector in the direction of a vector of any step, shorter than 2^63 steps.
///
/// Returns `None` if every component is below 2^10 steps.
pub(crate) fn direction(v: Vec3<i64>) -> Option<Vec3<Unit>> {
    let most = bits(v.x).max(bits(v.y)).max(bits(v.z));
    if most <= 10 {
        return None;
    }
    // Shifts the largest component to 30 bits. Rounding carries at most one bit.
    let v = if most <= 30 {
        v.map(|c| (c << (30 - most)) as i32)
    } else {
        v.map(|c| (((c >> (most - 31)) + 1) >> 1) as i32)
    };
    let square = v.map(|c| c.square());
    let inverse = inverse_length_outlined((square.x + square.y + square.z) as u64);
    Some(normalize(v, inverse).renormalized())
}
