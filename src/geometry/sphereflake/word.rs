//! Upper words: what is left of 64 bits without a shift.

use crate::math::{Product, high};

/// The upper word of a product.
#[inline(always)]
pub(super) fn upper_product(a: i32, b: i32) -> i32 {
    high(a.product(b))
}

/// The upper word of `x << shift`, for shifts of 1 to 31.
#[inline(always)]
pub(super) fn upper_shifted(x: i64, shift: u32) -> i32 {
    high(x) << (shift & 31) | (x as u32 >> (32_u32.wrapping_sub(shift) & 31)) as i32
}
