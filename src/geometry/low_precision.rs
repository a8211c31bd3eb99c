//! Vectors with 16-bit components. Products of two components fit 32 bits, so they need only
//! the multiply instruction that every core has.

use crate::math::{InverseLength, Length, Unit, Vec3};

/// Converts a unit vector to Q16, rounded down.
#[inline(always)]
pub(crate) fn to_q16(direction: Vec3<Unit>) -> Vec3<i32> {
    direction.map(|c| c.to_bits() >> 14)
}

/// Normalizes a vector and returns it in Q16. `inverse` is the reciprocal of its length. The
/// error of each component is below 2^-13.
#[inline(always)]
pub(crate) fn normalize_q16(v: Vec3<i32>, inverse: InverseLength) -> Vec3<i32> {
    // The vector is shifted so that its length is 2^30 to 2^31. The upper half of each
    // component is then multiplied by the upper half of the U1F31 reciprocal. `normalize`
    // multiplies full words instead.
    let shift = inverse.half_shift.wrapping_sub(1) & 31;
    let half = (inverse.inverse >> 16) as i32;
    v.map(|c| ((c << shift >> 16) * half) >> 14)
}

/// Converts a point to Q12, rounded down.
#[inline(always)]
pub(crate) fn to_q12(point: Vec3<Length>) -> Vec3<i32> {
    point.map(|c| c.to_bits() >> 16)
}

/// Returns the dot product of two vectors. The product of their lengths must be below 2^31.
#[inline(always)]
pub(crate) fn dot(a: Vec3<i32>, b: Vec3<i32>) -> i32 {
    let Vec3 { x, y, z } = a.zip(b, i32::wrapping_mul);
    x.wrapping_add(y).wrapping_add(z)
}
