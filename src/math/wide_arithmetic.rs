//! Arithmetic with 128-bit intermediate results.
//!
//! Preparing and animating scenes need such arithmetic, tracing does not. On a 32-bit core, each of
//! these operations takes 0.1 to 1 KB of code. The functions are therefore not inlined.

use super::format::Real;

/// Returns the product of two numbers, rounded down and saturated: `I32F32 * I32F32 -> I32F32`.
#[inline(never)]
pub(crate) fn multiply(a: Real, b: Real) -> Real {
    a.saturating_mul(b)
}

/// Returns `dividend / divisor`, rounded toward zero. Returns 0 if `divisor` is 0.
#[inline(never)]
pub(crate) fn divide(dividend: i128, divisor: i64) -> i128 {
    dividend.checked_div(divisor.into()).unwrap_or(0)
}

/// Returns `x * 2^shift`, rounded half up.
#[inline(never)]
pub(crate) fn shift_rounded(x: i128, shift: i32) -> i128 {
    if shift >= 0 {
        x << shift
    } else {
        (x + (1 << (-shift - 1))) >> -shift
    }
}
