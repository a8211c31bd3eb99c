use long_multiply::middle;

use super::quadratic_table::{Quadratic, SEGMENTS, below_two, evaluate, quadratic, refined};

/// Returns 1/x in steps of 2^-20, for `x` in steps of 2^-10. Evaluated at compile time.
const fn reciprocal_at(x: u64) -> u64 {
    below_two(((1 << 31) / x).div_ceil(2))
}

/// Quadratics of 1/x over [1/2, 1), indexed by the five bits below the top bit: 384 bytes.
static RECIPROCAL: [Quadratic; SEGMENTS] = {
    let mut table = [[0; 3]; SEGMENTS];
    let mut i = 0;
    while i < SEGMENTS {
        let x = 512 + 16 * i as u64;
        table[i] = quadratic(
            reciprocal_at(x),
            reciprocal_at(x + 8),
            reciprocal_at(x + 16),
        );
        i += 1;
    }
    table
};

/// Returns 1/x as `U1F31`, in (1, 2], for `x` in [1/2, 1) as `U0F32`.
///
/// Relative error below 2^-30. The top bit of `x` must be set.
#[inline]
pub(crate) fn reciprocal(x: u32) -> u32 {
    debug_assert!(x >> 31 == 1);
    let segment = RECIPROCAL[(x >> 26) as usize & (SEGMENTS - 1)];
    let y = evaluate(segment, (x >> 12) as i32 & 0x3fff);
    // e = 1 - x*y: U0F32 * U1F31 -> Q63; |e| < 2^-16 leaves 47 significant bits.
    let error = !middle(x, y << 11) as i32;
    // y + y*e: U1F31 * Q47 -> U1F31
    refined(y, error)
}

/// Calls [`reciprocal`] out of line, to save flash where speed does not matter.
#[inline(never)]
pub(crate) fn reciprocal_outlined(x: u32) -> u32 {
    reciprocal(x)
}
