use long_multiply::{middle, square_of_21_bits};

use super::quadratic_table::{Quadratic, SEGMENTS, below_two, evaluate, quadratic, refined};

/// Number of table segments. The segments are equal parts of the range from 0 to 1, so every index
/// of six bits is valid. Arguments below 1/4 do not occur, so the first quarter of the table is
/// unused.
const ROOT_SEGMENTS: usize = 2 * SEGMENTS;

/// Returns 1/sqrt(x) in Q20, for `x` in Q10. The function runs at compile time.
const fn reciprocal_root_at(x: u64) -> u64 {
    below_two(((1 << 62) / x).isqrt().div_ceil(1 << 6))
}

/// Quadratics that approximate 1/sqrt(x) for x in [1/4, 1). The top six bits of x are the index of
/// the quadratic. The table takes 768 bytes.
static RECIPROCAL_ROOT: [Quadratic; ROOT_SEGMENTS] = {
    let mut table = [[0; 3]; ROOT_SEGMENTS];
    let mut i = ROOT_SEGMENTS / 4;
    while i < ROOT_SEGMENTS {
        let x = 16 * i as u64;
        table[i] = quadratic(
            reciprocal_root_at(x),
            reciprocal_root_at(x + 8),
            reciprocal_root_at(x + 16),
        );
        i += 1;
    }
    table
};

/// Returns 1/sqrt(x) as `U1F31`, where `x` is a `U0F32` from 1/4 to 1.
///
/// The relative error is below 2^-30. At least one of the top two bits of `x` must be set.
#[inline]
pub(crate) fn reciprocal_root(x: u32) -> u32 {
    debug_assert!(x >> 30 != 0);
    let segment = RECIPROCAL_ROOT[(x >> 26) as usize];
    let y = evaluate(segment, (x >> 12) as i32 & 0x3fff);
    // `error` is 1 - x*y*y. The square of y is in Q30, and the product of this square and x is in
    // Q62. The error is below 2^-15, so the top bits of the product are not needed. The middle 32
    // bits hold the error in Q46.
    let error = !middle(x, square_of_21_bits(y)) as i32;
    // Returns y + y * error / 2. The error is in Q46, but `refined` reads it as Q47, which halves
    // it.
    refined(y, error)
}
