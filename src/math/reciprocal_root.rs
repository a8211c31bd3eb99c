use long_multiply::{middle, square_of_21_bits};

use super::quadratic_table::{Quadratic, SEGMENTS, below_two, evaluate, quadratic, refined};

/// Number of table segments. The table covers arguments from 0 to 1 in equal segments, so that no
/// index of six bits is out of range. Arguments below 1/4 do not occur, so the first quarter of the
/// table is unused.
const ROOT_SEGMENTS: usize = 2 * SEGMENTS;

/// Returns 1/sqrt(x) in Q20, for `x` in Q10. The function runs at compile time.
const fn reciprocal_root_at(x: u64) -> u64 {
    below_two(((1 << 62) / x).isqrt().div_ceil(1 << 6))
}

/// Quadratics that approximate 1/sqrt(x) for x in [1/4, 1). The index is the top six bits of x. The
/// table takes 768 bytes.
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
    // `error` is 1 - x*y*y. The square of y has Q30, and its product with x has Q62. Because the
    // error is below 2^-15, the top bits are not needed, and the middle 32 bits hold it in Q46.
    let error = !middle(x, square_of_21_bits(y)) as i32;
    // Returns y + y * error / 2. Reading an error in Q46 as Q47 halves it.
    refined(y, error)
}
