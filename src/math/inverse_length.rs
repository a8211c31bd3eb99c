use long_multiply::{leading_zeros, upper};

use super::format::Unit;
use super::product::wide;
use super::reciprocal_root::reciprocal_root;
use super::word::shifted;

/// The reciprocal square root of an integer `n`.
///
/// The fields represent `n` as `normalized * 2^(64 - 2*half_shift)`, with `normalized` in [1/4, 1).
/// Usually, `n` is the squared length of a vector. The reciprocal root then serves three purposes:
/// to scale the vector to unit length, to compute the cosine between the vector and a direction,
/// and to compute the length of the vector.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InverseLength {
    /// The upper word of `n`, after a shift by an even number of bits: `U0F32` in [1/4, 1).
    pub(crate) normalized: u32,
    /// `1/sqrt(normalized)` as `U1F31`, with a relative error below 2^-30.
    pub(crate) inverse: u32,
    /// Half the number of bits by which `n` was shifted up: 0 to 31.
    pub(crate) half_shift: u32,
}

/// Computes the reciprocal square root of an integer. An argument of 0 is treated as 1.
#[inline]
pub(crate) fn inverse_length(square: u64) -> InverseLength {
    let (high, low) = ((square >> 32) as u32, square as u32);
    if high == 0 {
        return inverse_length_of_word(low);
    }
    inverse_length_of(high, low)
}

/// Calls [`inverse_length`], but is not inlined. This saves flash where speed does not matter.
#[inline(never)]
pub(crate) fn inverse_length_outlined(square: u64) -> InverseLength {
    inverse_length(square)
}

/// Computes the reciprocal square root of `high * 2^32 + low`. `high` must not be 0.
fn inverse_length_of(high: u32, low: u32) -> InverseLength {
    let up = leading_zeros(high) & 30;
    let normalized = shifted(high, low, up);
    InverseLength {
        normalized,
        inverse: reciprocal_root(normalized),
        half_shift: up / 2,
    }
}

/// Computes the reciprocal square root of an integer below 2^32. An argument of 0 counts as 1.
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
    /// Returns the cosine of the angle between a vector and a direction. `self` is the inverse
    /// length of the vector.
    ///
    /// `along` is the dot product of the vector and the direction, computed with their raw bits.
    /// The direction is a [`Unit`] vector. The error of the cosine is below 2^-28.
    pub(crate) fn cosine(self, along: i64) -> Unit {
        // The length is below 2^(32 - half_shift), therefore |scaled| is below 2^30.
        let (high, low) = ((along >> 32) as i32, along as u32);
        let scaled = high << self.half_shift | ((low >> 1) >> (31 - self.half_shift)) as i32;
        // `inverse` is a number from 1 to 2 in `U1F31`, which is too large for a signed word. The
        // cast to a signed word subtracts 2. The signed multiply is one instruction on most cores.
        // Adding twice `scaled` corrects the product.
        let product = upper(scaled, self.inverse as i32);
        Unit::from_bits((scaled << 1).wrapping_add(product))
    }

    /// Returns `sqrt(n)`, rounded to an integer. The relative error of the root before rounding is
    /// below 2^-29.
    #[inline]
    pub(crate) fn length(self) -> u32 {
        // The product of `U0F32` and `U1F31` has Q63 and is in [1/2, 1). Times 2^(32 - half_shift),
        // it is the root of `n`.
        let root = wide(self.normalized, self.inverse);
        if self.half_shift < 2 {
            let shift = 31 + self.half_shift;
            return ((root + (1 << (shift - 1))) >> shift).min(u64::from(u32::MAX)) as u32;
        }
        let twice = (root >> 32) as u32 >> (self.half_shift - 2);
        (twice + 1) >> 1
    }
}
