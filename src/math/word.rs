//! Shifts and rounding that convert 64-bit numbers to 32-bit words.
//!
//! On Armv6-M, a 64-bit shift by a variable amount is a library call. The functions of this file
//! avoid the call: they shift the upper and the lower word separately.

use long_multiply::{leading_zeros, rounded};

use super::format::{Length, Unit};
use super::product::Product;

/// Shifts the 64-bit number `high * 2^32 + low` to the left by `up` bits and returns the upper
/// word of the result. `up` must be from 0 to 31.
pub(super) fn shifted(high: u32, low: u32, up: u32) -> u32 {
    high << up | (low >> 1) >> (31 - up)
}

/// Normalizes a number `x` above 0 so that its top bit is set.
///
/// Returns the upper word of `x << shift`, and `shift`, which is the number of leading zeros of
/// `x`.
pub(super) fn shifted_up(x: u64) -> (u32, u32) {
    let (mut high, mut low, mut shift) = ((x >> 32) as u32, x as u32, 0);
    if high == 0 {
        (high, low, shift) = (at_least_one(low), 0, 32);
    }
    let up = leading_zeros(high);
    (shifted(high, low, up), shift + up)
}

/// Returns the lower word of a number below 2^32, or 1 if the word is 0.
///
/// Numbers below 2^32 are rare. For such a number, [`shifted_up`] branches to this function,
/// which is not inlined. The branch costs less than counting the leading zeros of two words for
/// every number.
#[cold]
#[inline(never)]
fn at_least_one(low: u32) -> u32 {
    low.max(1)
}

/// Returns the number of bits of `|x|` without leading zeros: 0 for 0, 64 for -2^63.
pub(crate) fn bits(x: i64) -> i32 {
    64 - x.unsigned_abs().leading_zeros() as i32
}

/// Returns the upper word of a 64-bit number: `bits / 2^32`, rounded down.
pub(crate) fn high(bits: i64) -> i32 {
    (bits >> 32) as i32
}

/// Returns the upper word of the 64-bit product of two words.
pub(crate) fn upper_word(a: i32, b: i32) -> i32 {
    high(a.product(b))
}

/// Rounds `bits / 2^SHIFT` half up and returns it as the raw bits of a [`Unit`].
pub(crate) fn round_unit<const SHIFT: u32>(bits: i64) -> Unit {
    Unit::from_bits(rounded::<SHIFT>(bits))
}

/// Rounds `bits / 2^SHIFT` half up and returns it as the raw bits of a [`Length`].
pub(crate) fn round_length<const SHIFT: u32>(bits: i64) -> Length {
    Length::from_bits(rounded::<SHIFT>(bits))
}
