//! Full products of two 32-bit integers.
//!
//! Armv6-M (Cortex-M0 and M0+) multiplies 32 by 32 bits and keeps the lower 32.
//! For a full product the compiler calls one of 64 by 64 bits there: 38
//! instructions. Here it takes 19 with the call, a square 10 and no call. On
//! other targets these functions are the plain products.

#![no_std]

#[cfg(armv6m)]
mod armv6m;
#[cfg(armv6m)]
use armv6m as products;

#[cfg(not(armv6m))]
mod plain;
#[cfg(not(armv6m))]
use plain as products;

/// a b
#[inline(always)]
pub fn signed(a: i32, b: i32) -> i64 {
    products::signed(a, b)
}

/// a b
#[inline(always)]
pub fn unsigned(a: u32, b: u32) -> u64 {
    products::unsigned(a, b)
}

/// a b
#[inline(always)]
pub fn mixed(a: i32, b: u32) -> i64 {
    products::mixed(a, b)
}

/// a²
#[inline(always)]
pub fn square(a: i32) -> i64 {
    products::square(a)
}
