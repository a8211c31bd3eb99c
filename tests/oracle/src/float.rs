//! Number type of the tracer: f32 or f64.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Operations that the tracer needs of its numbers; implemented for f32 and f64.
pub trait Float:
    Copy
    + Debug
    + PartialOrd
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    const ZERO: Self;
    const ONE: Self;
    /// Distance from 1 to the next greater number.
    const ULP: Self;
    const INFINITY: Self;

    /// Returns the number nearest to a literal. Inlined, the conversion is free.
    fn lit(x: f64) -> Self;
    fn from_u32(x: u32) -> Self;
    fn to_f64(self) -> f64;
    /// Returns the greatest integer not above `self`, saturated to 32 bits.
    fn floor(self) -> i32;
    fn sqrt(self) -> Self;
    fn tan(self) -> Self;
    /// Returns `self` to any power, for a non-negative `self`.
    fn powf(self, exponent: Self) -> Self;

    fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }

    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    /// Returns `self` to the power of a shininess, 1 to 4096, for a non-negative
    /// `self`. Integer exponents use repeated squaring, which without an FPU is many
    /// times cheaper than the general power.
    #[inline(never)]
    fn pow(self, exponent: Self) -> Self {
        let mut whole = exponent.floor().unsigned_abs();
        if Self::from_u32(whole) != exponent {
            return self.powf(exponent);
        }
        let (mut square, mut power) = (self, Self::ONE);
        loop {
            if whole & 1 == 1 {
                power = power * square;
            }
            whole >>= 1;
            if whole == 0 {
                return power;
            }
            square = square * square;
        }
    }
}

/// Computes a square root by the FPU's instruction. `f32::sqrt` is not in `core` yet,
/// and libm computes it in integers. Inline assembly does not support FPU registers
/// yet, so the instruction needs a function.
#[cfg(all(target_arch = "arm", target_abi = "eabihf"))]
#[allow(unsafe_code)]
// SAFETY: the eabihf ABI passes both the argument and the result in s0.
#[unsafe(naked)]
extern "C" fn sqrtf(x: f32) -> f32 {
    core::arch::naked_asm!(".fpu fpv4-sp-d16", "vsqrt.f32 s0, s0", "bx lr")
}

#[cfg(not(all(target_arch = "arm", target_abi = "eabihf")))]
use libm::sqrtf;

macro_rules! float {
    ($float:ident, $sqrt:path, $tan:path, $pow:path) => {
        impl Float for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const ULP: Self = $float::EPSILON;
            const INFINITY: Self = $float::INFINITY;

            #[inline]
            fn lit(x: f64) -> Self {
                x as $float
            }

            #[inline]
            fn from_u32(x: u32) -> Self {
                x as $float
            }

            fn to_f64(self) -> f64 {
                self.into()
            }

            #[inline]
            fn floor(self) -> i32 {
                let toward_zero = self as i32;
                if toward_zero as $float > self {
                    toward_zero.saturating_sub(1)
                } else {
                    toward_zero
                }
            }

            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }

            fn tan(self) -> Self {
                $tan(self)
            }

            fn powf(self, exponent: Self) -> Self {
                $pow(self, exponent)
            }
        }
    };
}

float!(f32, sqrtf, libm::tanf, libm::powf);
float!(f64, libm::sqrt, libm::tan, libm::pow);
