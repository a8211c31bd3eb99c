//! The tangent of half the field of view, without floats.

use super::format::Real;
use super::product::wide;
use super::reciprocal::reciprocal;

/// The number 1 in Q60.
const ONE: i64 = 1 << 60;

/// Returns the product of two numbers in Q60, rounded down to Q60.
#[inline(never)]
fn multiply(a: i64, b: i64) -> i64 {
    ((i128::from(a) * i128::from(b)) >> 60) as i64
}

/// Returns tan(degrees / 2) as `U4F28`, for an angle of 1 to 170 degrees.
///
/// The sine and cosine are sums of twelve terms of their Taylor series, with errors below 2^-55.
/// Their quotient, the tangent, has an error below 2^-27 * (1 + tangent).
pub(crate) fn tangent_of_half(degrees: Real) -> u32 {
    const PI_BY_360: i64 = ((fixed::consts::PI.to_bits() / 360) >> 66) as i64;
    // Half the angle in radians: the product of Q32 and Q60 is shifted down to Q60.
    let x = ((i128::from(degrees.to_bits()) * i128::from(PI_BY_360)) >> 32) as i64;
    let square = multiply(x, x);
    // Evaluates the series 1 - x²/(k(k+1)) (1 - x²/((k+2)(k+3)) (1 - ...)), where k is `first`.
    let series = |first: i64| {
        (0..12)
            .rev()
            .map(|i| first + 2 * i)
            .fold(ONE, |sum, k| ONE - multiply(square, sum) / (k * (k + 1)))
    };
    let (sine, cosine) = (multiply(x, series(2)), series(1));
    let shift = cosine.leading_zeros();
    let inverse = reciprocal((((cosine as u64) << shift) >> 32) as u32);
    // The sine is shifted from Q60 to Q31. Its product with the reciprocal, a `U1F31`, is scaled by
    // 2^(shift - 4), because the cosine was shifted up, and rounded to Q28.
    let product = wide((sine >> 29) as u32, inverse);
    (((product >> (37 - shift)) + 1) >> 1) as u32
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;

    #[test]
    fn agrees_with_std() {
        for degrees in 1..=170_i32 {
            let exact = (f64::from(degrees) / 2.0).to_radians().tan();
            let got = f64::from(tangent_of_half(Real::from(degrees))) / 2_f64.powi(28);
            assert!(
                (got - exact).abs() < 2_f64.powi(-27) * (1.0 + exact),
                "{degrees}: {got} {exact}"
            );
        }
    }
}
