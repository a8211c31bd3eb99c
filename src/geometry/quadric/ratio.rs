use crate::math::{Real, Unit};

/// Returns `n / d`, rounded. The arguments must satisfy `0 < n <= |d|`. The result has the sign of
/// `d`.
pub(super) fn unit_ratio(n: Real, d: Real) -> Unit {
    let (n, d) = (i128::from(n.to_bits()), i128::from(d.to_bits()));
    let rounded = (n << 30) + (d.abs() >> 1);
    let quotient = rounded.checked_div(d.abs()).unwrap_or(0);
    Unit::from_bits((quotient * d.signum()) as i32)
}
