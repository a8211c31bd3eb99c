use super::inverse_length::inverse_length_outlined;

/// Returns `sqrt(x)`, rounded to an integer. Before rounding, the relative error of the root is
/// below 2^-29.
///
/// The root has half as many fraction bits as `x`: if `x` has Q56, the root has Q28.
#[inline(never)]
pub(crate) fn square_root(x: u64) -> u32 {
    if x == 0 {
        0
    } else {
        inverse_length_outlined(x).length()
    }
}
