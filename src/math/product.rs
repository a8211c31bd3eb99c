//! Exact 64-bit products of two 32-bit numbers.
//!
//! Armv7-M and later cores compute such a product in one instruction. Armv6-M cores have no
//! such instruction. On these cores, a product is a call of a function with 19 instructions,
//! and a square takes 10 inlined instructions.

use core::ops::Add;

use fixed::{FixedI32, FixedI64};

/// Exact multiplication of two 32-bit numbers.
pub(crate) trait Product<Other = Self> {
    /// The 64-bit format of the product. It has as many fraction bits as both operands
    /// together.
    type Output;

    /// Returns the exact product `self * other`.
    fn product(self, other: Other) -> Self::Output;
}

impl Product for i32 {
    type Output = i64;
    fn product(self, other: Self) -> i64 {
        long_multiply::signed(self, other)
    }
}

impl Product for u32 {
    type Output = u64;
    fn product(self, other: Self) -> u64 {
        long_multiply::unsigned(self, other)
    }
}

impl Product<u32> for i32 {
    type Output = i64;
    fn product(self, other: u32) -> i64 {
        long_multiply::mixed(self, other)
    }
}

impl<F: Add<G>, G> Product<FixedI32<G>> for FixedI32<F> {
    type Output = FixedI64<F::Output>;
    fn product(self, other: FixedI32<G>) -> Self::Output {
        FixedI64::from_bits(self.to_bits().product(other.to_bits()))
    }
}

/// Exact square of a 32-bit number.
pub(crate) trait Square {
    /// The 64-bit format of the square. It has twice as many fraction bits as the operand.
    type Output;

    /// Returns the exact square `self * self`. On Armv6-M a square is cheaper than a product.
    fn square(self) -> Self::Output;
}

impl Square for i32 {
    type Output = i64;
    fn square(self) -> i64 {
        long_multiply::square(self)
    }
}

impl<F: Add> Square for FixedI32<F> {
    type Output = FixedI64<F::Output>;
    fn square(self) -> Self::Output {
        FixedI64::from_bits(self.to_bits().square())
    }
}

/// Returns the exact 64-bit product of two unsigned 32-bit numbers.
pub(crate) fn wide(a: u32, b: u32) -> u64 {
    a.product(b)
}
