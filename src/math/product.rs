//! Full products of two 32-bit numbers.
//!
//! A product is one instruction on Armv7-M and later. On Armv6-M a product takes 19
//! instructions with its call, and a square 10 without a call.

use core::ops::Add;

use fixed::{FixedI32, FixedI64};

/// Exact multiplication of two 32-bit numbers.
pub(crate) trait Product<Other = Self> {
    /// 64-bit format with the fraction bits of both operands.
    type Output;

    /// Returns `self * other`, exact.
    fn product(self, other: Other) -> Self::Output;
}

impl Product for i32 {
    type Output = i64;
    #[inline(always)]
    fn product(self, other: Self) -> i64 {
        long_multiply::signed(self, other)
    }
}

impl Product for u32 {
    type Output = u64;
    #[inline(always)]
    fn product(self, other: Self) -> u64 {
        long_multiply::unsigned(self, other)
    }
}

impl Product<u32> for i32 {
    type Output = i64;
    #[inline(always)]
    fn product(self, other: u32) -> i64 {
        long_multiply::mixed(self, other)
    }
}

impl<F: Add<G>, G> Product<FixedI32<G>> for FixedI32<F> {
    type Output = FixedI64<F::Output>;
    #[inline(always)]
    fn product(self, other: FixedI32<G>) -> Self::Output {
        FixedI64::from_bits(self.to_bits().product(other.to_bits()))
    }
}

/// Exact square of a 32-bit number.
pub(crate) trait Square {
    /// 64-bit format with twice the fraction bits.
    type Output;

    /// Returns `self * self`, exact. Cheaper than a product on Armv6-M.
    fn square(self) -> Self::Output;
}

impl Square for i32 {
    type Output = i64;
    #[inline(always)]
    fn square(self) -> i64 {
        long_multiply::square(self)
    }
}

impl<F: Add> Square for FixedI32<F> {
    type Output = FixedI64<F::Output>;
    #[inline(always)]
    fn square(self) -> Self::Output {
        FixedI64::from_bits(self.to_bits().square())
    }
}

/// Returns the full product of two unsigned words, exact.
#[inline(always)]
pub(crate) fn wide(a: u32, b: u32) -> u64 {
    a.product(b)
}
