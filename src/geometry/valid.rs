//! Range checks of decoded values.

use core::ops::Neg;

use fixed::traits::Fixed;

use crate::math::{Color, Factor, Length, Unit, Vec3};

/// Returns true if a value is within ±`most`. The function avoids `abs`, because `abs` overflows
/// for the smallest number.
pub(crate) fn is_within<F: Fixed + Neg<Output = F>>(value: F, most: F) -> bool {
    (-most..=most).contains(&value)
}

/// Returns true if all coordinates are within ±`most`.
///
/// Several checks call this function. To save flash, it is not inlined and takes a reference.
#[inline(never)]
pub(crate) fn are_within(point: &Vec3<Length>, most: Length) -> bool {
    point.all(|c| is_within(c, most))
}

/// Returns true if all coordinates are within ±1.
pub(crate) fn is_within_one(point: &Vec3<Length>) -> bool {
    are_within(point, Length::ONE)
}

/// Returns true if the squared length of a vector is within 2^-20 of 1 and every component is
/// within ±1. Larger components would overflow the dot product.
#[inline(never)]
pub(crate) fn is_unit(v: &Vec3<Unit>) -> bool {
    v.all(|c| is_within(c, Unit::ONE)) && (v.dot(*v).to_bits() - (1 << 60)).abs() < 1 << 40
}

/// Returns true if two unit vectors are orthogonal, within 2^-20.
#[inline(never)]
pub(crate) fn are_orthogonal(u: &Vec3<Unit>, v: &Vec3<Unit>) -> bool {
    is_within(u.cosine(*v), Unit::DELTA * (1 << 10))
}

/// Returns true if a radius is positive and at most 1.
pub(crate) fn is_size(length: Length) -> bool {
    (Length::DELTA..=Length::ONE).contains(&length)
}

/// Returns true if all channels of the colors are at most 1.
#[inline(never)]
pub(crate) fn are_factors<const N: usize>(colors: [Color<Factor>; N]) -> bool {
    colors
        .into_iter()
        .all(|color| color.all(|c| c <= Factor::ONE))
}
