//! Full and rounded products of 32-bit integers, and how many zeros one begins with.
//!
//! Armv6-M (Cortex-M0 and M0+) multiplies 32 by 32 bits and keeps the lower 32.
//! For a full product the compiler calls one of 64 by 64 bits there: 38
//! instructions. Here it takes 19 with the call, a square 10 and no call, and the rounded
//! products of a vector of three and a number 53 to 56. Nor does it count zeros: the
//! compiler's routine takes some 35 instructions, this one 6 to 11.
//!
//! To round a product to a word takes 2 instructions on Armv7-M and Armv8-M mainline, 3 on
//! Armv6-M, where the compiler needs 4 and 6: a shift leaves in the carry what rounds. All else
//! is the plain operations on other targets.

#![no_std]

#[cfg(armv6m)]
mod armv6m;
#[cfg(armv6m)]
use armv6m as words;

#[cfg(armv7m)]
mod armv7m;
#[cfg(armv7m)]
use armv7m::rounded as shift;
#[cfg(not(armv7m))]
use words::rounded as shift;

#[cfg(not(armv6m))]
mod plain;
#[cfg(not(armv6m))]
use plain as words;

/// Whether a product is a call: it then pays to ask whether it can be left out.
pub const IS_CALL: bool = cfg!(armv6m);

/// a b
#[inline(always)]
pub fn signed(a: i32, b: i32) -> i64 {
    words::signed(a, b)
}

/// a b
#[inline(always)]
pub fn unsigned(a: u32, b: u32) -> u64 {
    words::unsigned(a, b)
}

/// a b
#[inline(always)]
pub fn mixed(a: i32, b: u32) -> i64 {
    words::mixed(a, b)
}

/// a b / 2^31, rounded down, for an `a` below 2^16.
#[inline(always)]
pub fn by_16_bits(a: u32, b: i32) -> i32 {
    words::by_16_bits(a, b)
}

/// a b / 2^17, rounded down, for an `a` of up to 2^16.
#[inline(always)]
pub fn by_17_bits(a: u32, b: u32) -> u32 {
    words::by_17_bits(a, b)
}

/// a b / 2^31, rounded half up, of which the lower 32 bits.
#[inline(always)]
pub fn upper(a: i32, b: i32) -> i32 {
    words::upper(a, b)
}

/// Each of `v` times `by`, over 2^`SHIFT`, rounded half up: of which the lower 32 bits.
/// `SHIFT` is 29 or 30.
#[inline(always)]
pub fn scaled<const SHIFT: u32>(v: [i32; 3], by: i32) -> [i32; 3] {
    const { assert!(SHIFT == 29 || SHIFT == 30) };
    words::scaled::<SHIFT>(v, by)
}

/// Each of `v` times `by`, which is 2^31 at least, over 2^32, rounded half up.
#[inline(always)]
pub fn reduced(v: [i32; 3], by: u32) -> [i32; 3] {
    words::reduced(v, by)
}

/// How many zeros `x` begins with: 0 to 32.
#[inline(always)]
pub fn leading_zeros(x: u32) -> u32 {
    words::leading_zeros(x)
}

/// a²
#[inline(always)]
pub fn square(a: i32) -> i64 {
    words::square(a)
}

/// a b / 2^16, rounded down, of which the lower 32 bits.
#[inline(always)]
pub fn middle(a: u32, b: u32) -> u32 {
    words::middle(a, b)
}

/// a² / 2^10, for an `a` below 2^21.
#[inline(always)]
pub fn square_of_21_bits(a: u32) -> u32 {
    words::square_of_21_bits(a)
}

/// x / 2^`SHIFT`, rounded half up: of which the lower 32 bits. `SHIFT` is 1 to 31.
#[inline(always)]
pub fn rounded<const SHIFT: u32>(x: i64) -> i32 {
    const { assert!(0 < SHIFT && SHIFT < 32) };
    shift::<SHIFT>(x)
}
