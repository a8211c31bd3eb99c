use super::product::wide;
use super::square_root::square_root;

/// Returns `base^exponent` as `U1F31`.
///
/// `base` is a `U1F31` from 0 to 1. `exponent` is a `U16F16` of at least 1. The error of the
/// result is below 2^-30 * (exponent + 16). Each bit of the exponent's integer part takes one or
/// two products. Each bit of its fraction takes one square root, down to the lowest bit that is
/// set.
#[inline(never)]
pub(crate) fn power(base: u32, exponent: u32) -> u32 {
    let Some(mut result) = integer_power(base, exponent >> 16) else {
        return 0;
    };
    let mut root = base;
    let mut fraction = exponent << 16;
    while fraction != 0 {
        // The argument of the square root has Q62, so the root has Q31.
        root = square_root(u64::from(root) << 31);
        if fraction >> 31 == 1 {
            result = multiply(result, root);
        }
        fraction <<= 1;
    }
    result
}

/// Returns `base^exponent` as `U1F31`, for an integer exponent. The function squares `base`
/// repeatedly and returns `None` if one of the squares rounds to 0.
fn integer_power(base: u32, mut exponent: u32) -> Option<u32> {
    const ONE: u32 = 1 << 31;
    let (mut result, mut square) = (ONE, base);
    loop {
        if exponent & 1 == 1 {
            result = multiply(result, square);
        }
        exponent >>= 1;
        if exponent == 0 {
            return Some(result);
        }
        square = multiply(square, square);
        if square == 0 {
            return None;
        }
    }
}

/// Returns the product of two numbers, rounded half up: `U1F31 * U1F31 -> U1F31`.
fn multiply(a: u32, b: u32) -> u32 {
    ((wide(a, b) + (1 << 30)) >> 31) as u32
}
