use long_multiply::{leading_zeros, upper};

use super::format::Unit;
use super::product::wide;
use super::reciprocal_root::reciprocal_root;
use super::word::shifted;

/// The reciprocal square root of an integer `n = normalized * 2^(32 - 2*half_shift)`.
///
/// `n` is usually the squared length of a vector, so the value scales the vector to unit
/// length, gives its cosine to a direction, and gives the length itself.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InverseLength {
    /// `n` shifted up by an even number of bits: `U0F32` in [1/4, 1).
    pub(crate) normalized: u32,
    /// `1/sqrt(normalized)` as `U1F31`, relative error below 2^-30.
    pub(crate) inverse: u32,
    /// Half of the shift that normalized `n`: 0 to 31.
    pub(crate) half_shift: u32,
}

/// Computes the reciprocal square root of an integer. 0 counts as 1.
#[inline]
pub(crate) fn inverse_length(square: u64) -> InverseLength {
    let (high, low) = ((square >> 32) as u32, square as u32);
    if high == 0 {
        return inverse_length_of_word(low);
    }
    inverse_length_of(high, low)
}

/// Calls [`inverse_length`] out of line, to save flash where speed does not matter.
#[inline(never)]
pub(crate) fn inverse_length_outlined(square: u64) -> InverseLength {
    inverse_length(square)
}

/// Computes the reciprocal square root of `high:low`, at least 2^32.
#[inline(always)]
fn inverse_length_of(high: u32, low: u32) -> InverseLength {
    let up = leading_zeros(high) & 30;
    let normalized = shifted(high, low, up);
    InverseLength {
        normalized,
        inverse: reciprocal_root(normalized),
        half_shift: up / 2,
    }
}

/// Computes the reciprocal square root of a number below 2^32. 0 counts as 1.
#[cold]
#[inline(never)]
fn inverse_length_of_word(square: u32) -> InverseLength {
    let inverse = inverse_length_of(square.max(1), 0);
    InverseLength {
        half_shift: inverse.half_shift + 16,
        ..inverse
    }
}

impl InverseLength {
    /// Returns the cosine between the vector with this length and a direction.
    ///
    /// `along` is the dot product of the vector and the direction, in steps of 2^-30 of the
    /// vector's. Error below 2^-28.
    #[inline(always)]
    pub(crate) fn cosine(self, along: i64) -> Unit {
        // |scaled| < 2^30, because the length is below 2^(32 - half_shift).
        let (high, low) = ((along >> 32) as i32, along as u32);
        let scaled = high << self.half_shift | ((low >> 1) >> (31 - self.half_shift)) as i32;
        // U1F31 - 2 fits a signed word, which cores multiply in one instruction.
        let product = upper(scaled, self.inverse as i32);
        Unit::from_bits((scaled << 1).wrapping_add(product))
    }

    /// Returns `sqrt(n)`, rounded to an integer. Relative error before rounding below 2^-29.
    #[inline]
    pub(crate) fn length(self) -> u32 {
        // U0F32 * U1F31 -> Q63 in [1/2, 1), times 2^(32 - half_shift)
        let root = wide(self.normalized, self.inverse);
        if self.half_shift < 2 {
            let shift = 31 + self.half_shift;
            return ((root + (1 << (shift - 1))) >> shift).min(u64::from(u32::MAX)) as u32;
        }
        let twice = (root >> 32) as u32 >> (self.half_shift - 2);
        (twice + 1) >> 1
    }
}
