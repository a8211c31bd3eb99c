//! Products of a vector and a number.

use super::format::Unit;
use super::inverse_length::InverseLength;
use super::vec3::Vec3;

/// Returns `v * by / 2^SHIFT`, each component rounded half up; `SHIFT` is 29 or 30.
///
/// Takes 53 to 56 instructions on Armv6-M.
#[inline(always)]
pub(crate) fn scaled<const SHIFT: u32>(v: Vec3<i32>, by: i32) -> Vec3<i32> {
    let [x, y, z] = long_multiply::scaled::<SHIFT>([v.x, v.y, v.z], by);
    Vec3::new(x, y, z)
}

/// Scales a vector of any step to unit length, each component to 2^-30.
///
/// `inverse` is the [`InverseLength`] of the vector's squared length. The length must be
/// below 2^31 steps.
#[inline(always)]
pub(crate) fn normalize(v: Vec3<i32>, inverse: InverseLength) -> Vec3<Unit> {
    // Shifts the vector to a length of 2^30 to 2^31, so that its product with the reciprocal
    // has the result in the upper word.
    let shift = inverse.half_shift.wrapping_sub(1) & 31;
    let Vec3 { x, y, z } = v.map(|c| c << shift);
    let [x, y, z] = long_multiply::reduced([x, y, z], inverse.inverse);
    Vec3::new(x, y, z).map(Unit::from_bits)
}
