//! Roots, reciprocals and shifts of 64 bits by calls: for what is rare, where flash
//! counts more than time.

use super::fixed::{InverseLength, SoftFloat, inverse_length_of};

/// [`super::inverse_length`], not inlined.
#[inline(never)]
pub(crate) fn inverse_length(square: u64) -> InverseLength {
    super::fixed::inverse_length(square)
}

/// The same of a square below 2^32.
#[cold]
#[inline(never)]
pub(crate) fn inverse_length_of_word(square: u32) -> InverseLength {
    let inverse = inverse_length_of(square.max(1), 0);
    InverseLength {
        half_shift: inverse.half_shift + 16,
        ..inverse
    }
}

/// [`super::reciprocal`], not inlined.
#[inline(never)]
pub(crate) fn reciprocal(x: u32) -> u32 {
    super::fixed::reciprocal(x)
}

/// [`SoftFloat::to_bits`], not inlined.
#[inline(never)]
pub(crate) fn to_bits(x: SoftFloat) -> i64 {
    x.to_bits()
}
