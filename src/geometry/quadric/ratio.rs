use crate::math::{Real, Unit, divide};

/// Returns `n / d`, rounded. The arguments must satisfy `0 < n <= |d|`. The result has the sign of
/// `d`.
#[inline(never)]
pub(super) fn unit_ratio(n: Real, d: Real) -> Unit {
    let (n, d) = (i128::from(n.to_bits()), d.to_bits());
    let rounded = (n << 30) + i128::from(d.abs() >> 1);
    let quotient = divide(rounded, d.abs()) as i32;
    Unit::from_bits(quotient * d.signum() as i32)
}
