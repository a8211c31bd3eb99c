//! Full products of two numbers of 32 bits.

use core::ops::Add;

use fixed::{FixedI32, FixedI64};

/// The full product of two numbers, exact.
pub(crate) trait Product<Other = Self> {
    /// Twice as wide, with the fraction bits of both.
    type Output;

    /// self * other
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

/// The full square of a number, exact: cheaper than a product.
pub(crate) trait Square {
    /// Twice as wide, with twice the fraction bits.
    type Output;

    /// self * self
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
