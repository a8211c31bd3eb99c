use super::inverse_length::inverse_length_outlined;

/// Returns `sqrt(x)`, rounded to an integer. Relative error before rounding below 2^-29.
///
/// The root of a square in steps of 2^-2k is in steps of 2^-k.
#[inline(never)]
pub(crate) fn square_root(x: u64) -> u32 {
    if x == 0 {
        0
    } else {
        inverse_length_outlined(x).length()
    }
}
