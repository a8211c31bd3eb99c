//! Shifts and rounding that turn 64-bit numbers into words.
//!
//! A 64-bit shift by a variable amount is a library call on Armv6-M, so the functions here
//! shift the two words separately.

use long_multiply::{leading_zeros, rounded};

use super::format::{Length, Unit};
use super::product::Product;

/// Returns the upper word of `high:low << up`, where `up` is 0 to 31.
#[inline(always)]
pub(super) fn shifted(high: u32, low: u32, up: u32) -> u32 {
    high << up | (low >> 1) >> (31 - up)
}

/// Normalizes a number above 0.
///
/// Returns the upper word of `x << shift` and `shift`, the count of leading zeros of `x`.
#[inline(always)]
pub(super) fn shifted_up(x: u64) -> (u32, u32) {
    let (mut high, mut low, mut shift) = ((x >> 32) as u32, x as u32, 0);
    if high == 0 {
        (high, low, shift) = (at_least_one(low), 0, 32);
    }
    let up = leading_zeros(high);
    (shifted(high, low, up), shift + up)
}

/// Returns `low`, or 1 for 0.
///
/// Numbers below 2^32 are rare. A branch around this call costs less than counting the
/// leading zeros of two words every time.
#[cold]
#[inline(never)]
fn at_least_one(low: u32) -> u32 {
    low.max(1)
}

/// Returns the number of bits of `|x|`: 0 for 0, 64 for -2^63.
pub(crate) fn bits(x: i64) -> i32 {
    64 - x.unsigned_abs().leading_zeros() as i32
}

/// Returns the upper word of a product: `bits / 2^32`, rounded down.
#[inline(always)]
pub(crate) fn high(bits: i64) -> i32 {
    (bits >> 32) as i32
}

/// Returns the upper word of a product of two words.
#[inline(always)]
pub(crate) fn upper_word(a: i32, b: i32) -> i32 {
    high(a.product(b))
}

/// Returns `bits / 2^SHIFT` in steps of a [`Unit`], rounded half up.
#[inline(always)]
pub(crate) fn round_unit<const SHIFT: u32>(bits: i64) -> Unit {
    Unit::from_bits(rounded::<SHIFT>(bits))
}

/// Returns `bits / 2^SHIFT` in steps of a [`Length`], rounded half up.
#[inline(always)]
pub(crate) fn round_length<const SHIFT: u32>(bits: i64) -> Length {
    Length::from_bits(rounded::<SHIFT>(bits))
}
