//! Vectors, and the products and lengths of the formats that tracing uses.

use core::ops::{Add, Neg, Sub};

use fixed::types::{I4F60, I6F58, I8F56};

use crate::math::{
    InverseLength, Length, Product, Real, Square, Unit, inverse_length, outlined as rare, rounded,
};

/// A point or a vector: x to the right, y up, z towards the viewer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Vec3<T> {
    /// To the right.
    pub x: T,
    /// Up.
    pub y: T,
    /// Towards the viewer.
    pub z: T,
}

impl<T> Vec3<T> {
    /// The vector (x, y, z).
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }

    #[inline(always)]
    pub(crate) fn map<U>(self, f: impl Fn(T) -> U) -> Vec3<U> {
        Vec3::new(f(self.x), f(self.y), f(self.z))
    }

    /// Whether `f` holds for every component.
    #[inline(always)]
    pub(crate) fn all(self, f: impl Fn(T) -> bool) -> bool {
        f(self.x) && f(self.y) && f(self.z)
    }

    #[inline(always)]
    pub(crate) fn zip<U, V>(self, other: Vec3<U>, f: impl Fn(T, U) -> V) -> Vec3<V> {
        Vec3::new(f(self.x, other.x), f(self.y, other.y), f(self.z, other.z))
    }
}

impl Vec3<Real> {
    /// A constant, from decimal literals: `Vec3::lit("0.2", "2.3", "8.2")`.
    ///
    /// In a constant a malformed literal is a compile error.
    pub const fn lit(x: &str, y: &str, z: &str) -> Self {
        Self::new(Real::lit(x), Real::lit(y), Real::lit(z))
    }
}

impl<T: Add<Output = T>> Add for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.zip(other, T::add)
    }
}

impl<T: Sub<Output = T>> Sub for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        self.zip(other, T::sub)
    }
}

impl<T: Neg<Output = T>> Neg for Vec3<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        self.map(T::neg)
    }
}

impl Vec3<Length> {
    /// The dot product with another such vector.
    pub(crate) fn dot(self, other: Self) -> I8F56 {
        self.x.product(other.x) + self.y.product(other.y) + self.z.product(other.z)
    }

    /// The length along a direction, exact: `I4F28 * I2F30 -> I6F58`.
    #[inline(always)]
    pub(crate) fn along(self, direction: Vec3<Unit>) -> I6F58 {
        self.x.product(direction.x) + self.y.product(direction.y) + self.z.product(direction.z)
    }

    /// The square of its length, exact: `I4F28^2 -> I8F56`.
    #[inline(always)]
    pub(crate) fn squared(self) -> I8F56 {
        self.x.square() + self.y.square() + self.z.square()
    }

    /// The cross product with a direction: `I4F28 * I2F30 -> I4F28`, rounded.
    ///
    /// The length must be below 8.
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

    /// The unit vector along it, each component to 2^-30, and its length.
    ///
    /// The length must be below 8; the unit vector of zero is zero.
    #[inline(always)]
    pub(crate) fn normalized(self) -> (Vec3<Unit>, InverseLength) {
        let inverse = inverse_length(self.squared().to_bits() as u64);
        (normalize(self.map(Length::to_bits), inverse), inverse)
    }
}

/// Scales a vector of any step to a unit vector, given what
/// [`inverse_length`] says of its square. Its length is below 2^31 steps.
#[inline(always)]
pub(crate) fn normalize(v: Vec3<i32>, inverse: InverseLength) -> Vec3<Unit> {
    // The vector is shifted to a length of 2^30 to 2^31, so that the product
    // with the reciprocal has the result in its upper half.
    let shift = inverse.half_shift.wrapping_sub(1) & 31;
    let Vec3 { x, y, z } = v.map(|c| c << shift);
    let [x, y, z] = long_multiply::reduced([x, y, z], inverse.inverse);
    Vec3::new(x, y, z).map(Unit::from_bits)
}

/// How many bits a number has.
pub(crate) fn bits(x: i64) -> i32 {
    64 - x.unsigned_abs().leading_zeros() as i32
}

/// The unit vector along a vector of any step, below 2^63; `None` if it is
/// shorter than 2^10 steps.
pub(crate) fn direction(v: Vec3<i64>) -> Option<Vec3<Unit>> {
    let most = bits(v.x).max(bits(v.y)).max(bits(v.z));
    if most <= 10 {
        return None;
    }
    // Rounding carries at most one bit.
    let v = if most <= 30 {
        v.map(|c| (c << (30 - most)) as i32)
    } else {
        v.map(|c| (((c >> (most - 31)) + 1) >> 1) as i32)
    };
    let square = v.map(|c| c.square());
    let inverse = rare::inverse_length((square.x + square.y + square.z) as u64);
    Some(normalize(v, inverse).renormalized())
}

impl Vec3<Unit> {
    /// The product of two directions, exact: `I2F30^2 -> I4F60`.
    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> I4F60 {
        self.x.product(other.x) + self.y.product(other.y) + self.z.product(other.z)
    }

    /// The cross product, exact: `I2F30^2 -> I4F60`.
    pub(crate) fn cross(self, other: Self) -> Vec3<i64> {
        let minor = |p: Unit, q: Unit, r: Unit, s: Unit| (p.product(q) - r.product(s)).to_bits();
        Vec3::new(
            minor(self.y, other.z, self.z, other.y),
            minor(self.z, other.x, self.x, other.z),
            minor(self.x, other.y, self.y, other.x),
        )
    }

    /// The square of the length.
    #[inline(always)]
    fn squared(self) -> I4F60 {
        self.x.square() + self.y.square() + self.z.square()
    }

    /// The cosine between two unit vectors.
    #[inline(always)]
    pub(crate) fn cosine(self, other: Self) -> Unit {
        round_unit::<30>(self.dot(other).to_bits())
    }

    /// This direction, `distance` long: `I2F30 * I4F28 -> I4F28`, rounded.
    #[inline(always)]
    pub(crate) fn times(self, distance: Length) -> Vec3<Length> {
        scaled::<30>(self.map(Unit::to_bits), distance.to_bits()).map(Length::from_bits)
    }

    /// The unit vector along it; its length must be below 2.
    #[inline(always)]
    pub(crate) fn unit(self) -> Self {
        let inverse = inverse_length(self.squared().to_bits() as u64);
        normalize(self.map(Unit::to_bits), inverse)
    }

    /// The same, not inlined.
    #[inline(never)]
    pub(crate) fn unit_outlined(self) -> Self {
        let inverse = rare::inverse_length(self.squared().to_bits() as u64);
        normalize(self.map(Unit::to_bits), inverse)
    }

    /// A vector of nearly unit length made unit by one Newton step: n(3 - n²)/2.
    ///
    /// Deviations up to 2^-16 vanish in the rounding.
    #[inline]
    pub(crate) fn renormalized(self) -> Self {
        // Q60 -> Q30, a word of few bits
        let square = rounded::<30>(self.squared().to_bits());
        let excess = (1_i32 << 30).wrapping_sub(square);
        self.map(|c| {
            let step = (c.to_bits() >> 16)
                .wrapping_mul(excess)
                .wrapping_add(1 << 14)
                >> 15;
            Unit::from_bits(c.to_bits() + step)
        })
    }
}

/// A vector times a number, over 2^`SHIFT`, rounded.
#[inline(always)]
pub(crate) fn scaled<const SHIFT: u32>(v: Vec3<i32>, by: i32) -> Vec3<i32> {
    let [x, y, z] = long_multiply::scaled::<SHIFT>([v.x, v.y, v.z], by);
    Vec3::new(x, y, z)
}

/// The high word of a product: its low 32 bits are left out.
#[inline(always)]
pub(crate) fn high(bits: i64) -> i32 {
    (bits >> 32) as i32
}

/// Upper word of a product.
#[inline(always)]
pub(crate) fn upper_word(a: i32, b: i32) -> i32 {
    high(a.product(b))
}

/// Rounds away the low `SHIFT` bits.
#[inline(always)]
pub(crate) fn round_unit<const SHIFT: u32>(bits: i64) -> Unit {
    Unit::from_bits(rounded::<SHIFT>(bits))
}

/// Rounds away the low `SHIFT` bits.
#[inline(always)]
pub(crate) fn round_length<const SHIFT: u32>(bits: i64) -> Length {
    Length::from_bits(rounded::<SHIFT>(bits))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_asks_for_each_component() {
        let is_set = |bits: i32| Vec3::new(bits & 1, bits & 2, bits & 4).all(|c| c != 0);
        for bits in 0..8 {
            assert_eq!(is_set(bits), bits == 7, "{bits:03b}");
        }
    }
}
