use long_multiply::{middle, square_of_21_bits};

use super::quadratic_table::{Quadratic, SEGMENTS, below_two, evaluate, quadratic, refined};

/// Two factors of two. The first quarter, for arguments below 1/4, is unused: with it, no
/// index of six bits is out of range.
const ROOT_SEGMENTS: usize = 2 * SEGMENTS;

/// Returns 1/sqrt(x) in steps of 2^-20, for `x` in steps of 2^-10. Evaluated at compile time.
const fn reciprocal_root_at(x: u64) -> u64 {
    below_two(((1 << 62) / x).isqrt().div_ceil(1 << 6))
}

/// Quadratics of 1/sqrt(x) over [1/4, 1), indexed by the top six bits: 768 bytes.
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

/// Returns 1/sqrt(x) as `U1F31`, in (1, 2], for `x` in [1/4, 1) as `U0F32`.
///
/// Relative error below 2^-30. One of the top two bits of `x` must be set.
#[inline]
pub(crate) fn reciprocal_root(x: u32) -> u32 {
    debug_assert!(x >> 30 != 0);
    let segment = RECIPROCAL_ROOT[(x >> 26) as usize];
    let y = evaluate(segment, (x >> 12) as i32 & 0x3fff);
    // e = 1 - x*y*y: U1F20^2 -> U2F30, * U0F32 -> Q62; |e| < 2^-15 leaves 48 significant bits.
    let error = !middle(x, square_of_21_bits(y)) as i32;
    // y + y*e/2: U1F31 * Q46 -> U1F31
    refined(y, error)
}
