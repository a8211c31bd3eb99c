//! Piecewise quadratics and the Newton step, for reciprocals and reciprocal roots.
//!
//! The library never divides while it traces, because the Cortex-M0+ has no divider. A
//! table of quadratics gives a function to 2^-17, and one Newton step refines the result to
//! 2^-30. The compiler computes the tables in integers.

use long_multiply::by_16_bits;

/// Segments for each factor of two of the argument.
pub(super) const SEGMENTS: usize = 32;

/// Coefficients `c0, c1, c2` of `c0 + c1 x + c2 x²` over one segment, in steps of 2^-20.
pub(super) type Quadratic = [i32; 3];

/// Returns the quadratic through the values at the start, middle and end of a segment.
pub(super) const fn quadratic(start: u64, middle: u64, end: u64) -> Quadratic {
    let (c0, middle, end) = (start as i32, middle as i32, end as i32);
    [c0, 4 * middle - 3 * c0 - end, 2 * (c0 + end) - 4 * middle]
}

/// Limits a table value to 2 - 2^-20, so that it fits `U1F31` after a shift by 11 bits.
pub(super) const fn below_two(x: u64) -> u64 {
    if x >> 21 == 0 { x } else { (1 << 21) - 1 }
}

/// Returns the value of a quadratic in steps of 2^-20.
///
/// `x` is the position in the segment in steps of 2^-14.
#[inline(always)]
pub(super) fn evaluate([c0, c1, c2]: Quadratic, x: i32) -> u32 {
    (c0 + (((c1 + ((c2 * x) >> 14)) * x) >> 14)) as u32
}

/// Applies the Newton step `y + y * error`: returns `U1F31`.
///
/// `y` is in steps of 2^-20 and `error` in steps of 2^-47, below 2^-15. The result never
/// exceeds the true value, so it stays below 2.
#[inline(always)]
pub(super) fn refined(y: u32, error: i32) -> u32 {
    // The step is below 2^-15 of `y`, so 16 bits of `y` are enough.
    (y << 11).wrapping_add_signed(by_16_bits(y >> 5, error))
}
