use super::format::{Length, NEAR_LIMIT};
use super::product::wide;
use super::reciprocal::reciprocal;
use super::word::shifted_up;

/// A number `mantissa * 2^exponent`, not negative.
///
/// As long as the top bit of each mantissa is set, comparing two of them compares their
/// values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct SoftFloat {
    pub(crate) exponent: i32,
    pub(crate) mantissa: u32,
}

impl SoftFloat {
    /// Zero, which compares below every quotient.
    pub(crate) const ZERO: Self = Self {
        mantissa: 0,
        exponent: -64,
    };

    /// Converts a distance of at least 0, without setting the top bit of the mantissa.
    ///
    /// The result must not be compared with other numbers.
    pub(crate) fn unordered(distance: Length) -> Self {
        Self {
            mantissa: distance.to_bits() as u32,
            exponent: 0,
        }
    }

    /// Returns the number, in steps of 2^-28, as a distance below [`NEAR_LIMIT`], rounded half
    /// up; `None` if the number is not below.
    #[inline]
    pub(crate) fn near(self) -> Option<Length> {
        let shift = self.exponent.checked_neg()?.checked_sub(1)?;
        let half = self.mantissa.checked_shr(u32::try_from(shift).ok()?);
        let half = half.unwrap_or(0);
        let rounded = (half >> 1) + (half & 1);
        (rounded < NEAR_LIMIT.to_bits() as u32).then_some(Length::from_bits(rounded as i32))
    }

    /// Returns the number rounded down to an integer. The number must be below 2^63.
    #[inline(never)]
    pub(crate) fn to_bits(self) -> i64 {
        let mantissa = i64::from(self.mantissa);
        if self.exponent < 0 {
            mantissa >> (-self.exponent).min(63)
        } else {
            mantissa << self.exponent
        }
    }
}

/// Returns `2^30 n / d` for `n` and `d` above 0. Relative error below 2^-29.
///
/// The quotient of Q58 by Q60, of Q56 by Q58 or of Q28 by Q30 is in steps of 2^-28.
#[inline]
pub(crate) fn quotient(n: u64, d: u64) -> SoftFloat {
    let ((n, n_shift), (d, d_shift)) = (shifted_up(n), shifted_up(d));
    let (mantissa, last) = shifted_up(wide(n, reciprocal(d | 1 << 31)));
    // n = mantissa * 2^(32 - n_shift), 1/d = reciprocal * 2^(d_shift - 95), and
    // product = mantissa of the quotient * 2^(32 - last).
    SoftFloat {
        mantissa,
        exponent: d_shift as i32 - n_shift as i32 - last as i32 - 1,
    }
}

/// Returns `a b / 2^(64 - shift)`, rounded down. Relative error before rounding below 2^-30.
#[inline(never)]
pub(crate) fn upper_product(a: u64, b: u64, shift: u32) -> u64 {
    let ((a, a_shift), (b, b_shift)) = (shifted_up(a), shifted_up(b));
    let product = wide(a, b);
    let down = (a_shift + b_shift) as i32 - shift as i32;
    if down >= 0 {
        product.checked_shr(down as u32).unwrap_or(0)
    } else {
        product << -down
    }
}
