//! Computes reciprocals and reciprocal square roots by tables of quadratics and a Newton step.
//!
//! The library does not divide while it traces rays, because the Cortex-M0+ has no divider.
//! Instead, a quadratic from a table approximates the reciprocal or the reciprocal root to 2^-17.
//! One Newton step then refines this approximation to 2^-30. The tables are computed at compile
//! time, in integers.

use long_multiply::by_16_bits;

/// Number of table segments for each factor of two of the argument, for example from 1/2 to 1.
pub(super) const SEGMENTS: usize = 32;

/// Coefficients `[c0, c1, c2]` in Q20. Over one segment of a table, the function is approximated by
/// `c0 + c1 x + c2 x²`, where x runs from 0 to 1.
pub(super) type Quadratic = [i32; 3];

/// Returns the quadratic that has the given values at the start, middle and end of a segment.
pub(super) const fn quadratic(start: u64, middle: u64, end: u64) -> Quadratic {
    let (c0, middle, end) = (start as i32, middle as i32, end as i32);
    [c0, 4 * middle - 3 * c0 - end, 2 * (c0 + end) - 4 * middle]
}

/// Limits a value in Q20 to 2 - 2^-20, so that a shift by 11 bits converts it to `U1F31`.
pub(super) const fn below_two(x: u64) -> u64 {
    if x >> 21 == 0 { x } else { (1 << 21) - 1 }
}

/// Returns the value of a quadratic at `x`, in Q20.
///
/// `x` is the position in the segment: 0 at its start and 1 at its end, in Q14.
pub(super) fn evaluate([c0, c1, c2]: Quadratic, x: i32) -> u32 {
    (c0 + (((c1 + ((c2 * x) >> 14)) * x) >> 14)) as u32
}

/// Applies the Newton step: returns `y + y * error` as `U1F31`.
///
/// `y` has Q20. `error` has Q47 and is below 2^-15. The result never exceeds the true value of the
/// function, so it stays below 2.
pub(super) fn refined(y: u32, error: i32) -> u32 {
    // The Newton step changes `y` by less than `2^-15 * y`. The top 16 bits of `y` are therefore
    // enough to compute the change.
    (y << 11).wrapping_add_signed(by_16_bits(y >> 5, error))
}
