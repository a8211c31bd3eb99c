//! Multiplies 32-bit integers for fixed-point arithmetic on microcontrollers.
//!
//! Armv6-M (Cortex-M0 and M0+) has no instruction for a 64-bit product: `muls` returns
//! the lower 32 bits. For a 64-bit product, compiled code calls a 64x64-bit routine of
//! 38 instructions. The assembly of this crate takes fewer instructions:
//!
//! | operation on Armv6-M | instructions | compiler |
//! |---|--:|--:|
//! | full product, with the call | 19 | 38 |
//! | full square, inlined | 10 | 38 |
//! | rounded product of a 3-vector and a scalar, with the call | 53 to 56 | |
//! | leading zeros | 6 to 11 | about 35 |
//! | rounding shift of an `i64` to 32 bits | 3 | 6 |
//!
//! On Armv7-M and Armv8-M mainline, only the rounding shift is written in assembly. It
//! takes 2 instructions instead of the compiler's 4. The other operations on these targets
//! are plain Rust, and so are all operations on any other target. All implementations
//! return the same bits.
//!
//! In the function descriptions, "rounded down" is toward negative infinity and "rounded
//! half up" is `floor(x + 1/2)`.

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

/// True if a full product is a function call, which is the case on Armv6-M.
///
/// On Armv6-M, checking whether a product is needed can be cheaper than computing it.
pub const IS_CALL: bool = cfg!(armv6m);

/// Returns the full product `a * b` of two signed integers.
#[inline(always)]
pub fn signed(a: i32, b: i32) -> i64 {
    words::signed(a, b)
}

/// Returns the full product `a * b` of two unsigned integers.
#[inline(always)]
pub fn unsigned(a: u32, b: u32) -> u64 {
    words::unsigned(a, b)
}

/// Returns the full product `a * b` of a signed and an unsigned integer.
#[inline(always)]
pub fn mixed(a: i32, b: u32) -> i64 {
    words::mixed(a, b)
}

/// Returns `a * b / 2^31`, rounded down, for `a < 2^16`.
#[inline(always)]
pub fn by_16_bits(a: u32, b: i32) -> i32 {
    words::by_16_bits(a, b)
}

/// Returns `a * b / 2^17`, rounded down, for `a <= 2^16`.
#[inline(always)]
pub fn by_17_bits(a: u32, b: u32) -> u32 {
    words::by_17_bits(a, b)
}

/// Returns the lower 32 bits of `a * b / 2^31`, rounded half up.
#[inline(always)]
pub fn upper(a: i32, b: i32) -> i32 {
    words::upper(a, b)
}

/// Returns the lower 32 bits of `v[i] * by / 2^SHIFT`, rounded half up, for each component
/// `v[i]`.
///
/// `SHIFT` must be 29 or 30; other values do not compile.
#[inline(always)]
pub fn scaled<const SHIFT: u32>(v: [i32; 3], by: i32) -> [i32; 3] {
    const { assert!(SHIFT == 29 || SHIFT == 30) };
    words::scaled::<SHIFT>(v, by)
}

/// Returns `v[i] * by / 2^32`, rounded half up, for each component `v[i]`. Requires
/// `by >= 2^31`.
#[inline(always)]
pub fn reduced(v: [i32; 3], by: u32) -> [i32; 3] {
    words::reduced(v, by)
}

/// Returns the number of leading zero bits of `x`: 0 to 32.
#[inline(always)]
pub fn leading_zeros(x: u32) -> u32 {
    words::leading_zeros(x)
}

/// Returns the full square `a * a` of a signed integer.
#[inline(always)]
pub fn square(a: i32) -> i64 {
    words::square(a)
}

/// Returns the lower 32 bits of `a * b / 2^16`, rounded down.
#[inline(always)]
pub fn middle(a: u32, b: u32) -> u32 {
    words::middle(a, b)
}

/// Returns `a * a / 2^10`, rounded down, for `a < 2^21`.
#[inline(always)]
pub fn square_of_21_bits(a: u32) -> u32 {
    words::square_of_21_bits(a)
}

/// Returns the lower 32 bits of `x / 2^SHIFT`, rounded half up.
///
/// `SHIFT` must be 1 to 31; other values do not compile.
#[inline(always)]
pub fn rounded<const SHIFT: u32>(x: i64) -> i32 {
    const { assert!(0 < SHIFT && SHIFT < 32) };
    shift::<SHIFT>(x)
}
