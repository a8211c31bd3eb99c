use long_multiply::middle;

use super::quadratic_table::{Quadratic, SEGMENTS, below_two, evaluate, quadratic, refined};

/// Returns 1/x in Q20, for `x` in Q10. The function runs at compile time.
const fn reciprocal_at(x: u64) -> u64 {
    below_two(((1 << 31) / x).div_ceil(2))
}

/// Quadratics that approximate 1/x for x in [1/2, 1). The five bits of x below its top bit are the
/// index of the quadratic. The table takes 384 bytes.
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

/// Returns 1/x as `U1F31`, where `x` is a `U0F32` from 1/2 to 1.
///
/// The relative error is below 2^-30. The top bit of `x` must be set.
#[inline]
pub(crate) fn reciprocal(x: u32) -> u32 {
    debug_assert!(x >> 31 == 1);
    let segment = RECIPROCAL[(x >> 26) as usize & (SEGMENTS - 1)];
    let y = evaluate(segment, (x >> 12) as i32 & 0x3fff);
    // `error` is 1 - x*y. The product of x, a `U0F32`, and y, a `U1F31`, is in Q63. The error is
    // below 2^-16, so the top 16 bits of the product are not needed. The middle 32 bits hold the
    // error in Q47.
    let error = !middle(x, y << 11) as i32;
    // Returns y + y * error.
    refined(y, error)
}

/// Calls [`reciprocal`] and is not inlined. This saves flash where speed does not matter.
#[inline(never)]
pub(crate) fn reciprocal_outlined(x: u32) -> u32 {
    reciprocal(x)
}
