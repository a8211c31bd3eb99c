//! Multiplication of a vector by a number.

use super::format::Unit;
use super::inverse_length::InverseLength;
use super::vec3::Vec3;

/// Returns `v * by / 2^SHIFT`. Each component is rounded half up. `SHIFT` must be 29 or 30.
///
/// The multiplication takes 53 to 56 instructions on Armv6-M.
#[inline(always)]
pub(crate) fn scaled<const SHIFT: u32>(v: Vec3<i32>, by: i32) -> Vec3<i32> {
    let [x, y, z] = long_multiply::scaled::<SHIFT>([v.x, v.y, v.z], by);
    Vec3::new(x, y, z)
}

/// Scales a vector to unit length. The components of the result have a resolution of 2^-30.
///
/// The vector may be in any unit, but must be shorter than 2^31 units. `inverse` is the
/// [`InverseLength`] computed from the vector's squared length.
#[inline(always)]
pub(crate) fn normalize(v: Vec3<i32>, inverse: InverseLength) -> Vec3<Unit> {
    // The shift gives the vector a length from 2^30 to 2^31. Each component is then
    // multiplied by the reciprocal length. The upper word of the product is the component of
    // the result.
    let shift = inverse.half_shift.wrapping_sub(1) & 31;
    let Vec3 { x, y, z } = v.map(|c| c << shift);
    let [x, y, z] = long_multiply::reduced([x, y, z], inverse.inverse);
    Vec3::new(x, y, z).map(Unit::from_bits)
}
