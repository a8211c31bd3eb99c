use super::format::{Length, NEAR_LIMIT};
use super::product::wide;
use super::reciprocal::reciprocal;
use super::word::shifted_up;

/// A floating-point number of at least 0: `mantissa * 2^exponent`.
///
/// The order of two `SoftFloat`s is the order of their values only if the top bit of each mantissa
/// is set.
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

    /// Converts a distance of at least 0 to a `SoftFloat`, without normalizing the mantissa.
    ///
    /// The result must not be compared with other `SoftFloat`s, because the top bit of its mantissa
    /// is not set.
    pub(crate) fn unordered(distance: Length) -> Self {
        Self {
            mantissa: distance.to_bits() as u32,
            exponent: 0,
        }
    }

    /// Returns the number as a distance, rounded half up. One unit of the number is a distance of
    /// 2^-28. Returns `None` if the distance is [`NEAR_LIMIT`] or more.
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

/// Returns `2^30 n / d` for `n` and `d` above 0. The relative error is below 2^-29.
///
/// If `d` has two more fraction bits than `n`, for example Q60 and Q58, the quotient has Q28.
#[inline]
pub(crate) fn quotient(n: u64, d: u64) -> SoftFloat {
    let ((n, n_shift), (d, d_shift)) = (shifted_up(n), shifted_up(d));
    let (mantissa, last) = shifted_up(wide(n, reciprocal(d | 1 << 31)));
    // The exponent adds up these shifts: the numerator is n * 2^(32 - n_shift), the reciprocal of
    // the divisor is reciprocal * 2^(d_shift - 95), and the product of n and the reciprocal is
    // mantissa * 2^(32 - last).
    SoftFloat {
        mantissa,
        exponent: d_shift as i32 - n_shift as i32 - last as i32 - 1,
    }
}

/// Returns `a * b / 2^(64 - shift)`, rounded down. Before rounding, the relative error of the
/// result is below 2^-30.
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
