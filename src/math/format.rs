//! Number formats of the library, and conversions of authored numbers.
//!
//! | format | used for | range | step |
//! |---|---|---|---|
//! | [`Real`] | authored numbers | ±2^31 | 2^-32 |
//! | [`Length`] | positions and distances in a prepared scene | ±8 | 2^-28 |
//! | [`Unit`] | components of unit vectors, cosines | ±2 | 2^-30 |
//! | [`Factor`] | material coefficients, colors of lights | 0 to 1 | 2^-15 |
//! | [`Intensity`] | cosines and highlights that scale a light | 0 to 1 | 2^-16 |
//! | [`Weight`] | contribution of a ray to its pixel | 0 to 1 | 2^-32 |
//! | [`Radiance`] | light that returns along a ray | 0 to 4 | 2^-30 |

/// An authored number: ±2^31 in steps of 2^-32.
///
/// `Real::lit("0.25")` parses a decimal literal at compile time.
pub type Real = fixed::types::I32F32;

/// A position or distance in a prepared scene: ±8 in steps of 2^-28.
///
/// Preparing scales a scene so that its finite geometry lies within ±1.
pub(crate) type Length = fixed::types::I4F28;

/// A cosine or a component of a unit vector: ±2 in steps of 2^-30.
pub(crate) type Unit = fixed::types::I2F30;

/// A material coefficient or one channel of a light: 0 to 1 in steps of 2^-15.
///
/// A factor has 16 bits, so the product of two factors fits a 32-bit multiply.
pub(crate) type Factor = fixed::types::U1F15;

/// A cosine or a highlight that scales a light: 0 to 1 in steps of 2^-16.
///
/// The product of an intensity and a factor fits 32 bits.
pub(crate) type Intensity = fixed::types::U16F16;

/// The contribution of a ray to its pixel: 0 to 1 in steps of 2^-32.
///
/// The largest weight, 1 - 2^-32, stands for 1. The upper word of the product of a weight and
/// a radiance is a radiance.
pub(crate) type Weight = fixed::types::U0F32;

/// Linear radiance of one channel: 0 to just below 4 in steps of 2^-30.
///
/// White is 1. Sums saturate at the largest value.
pub type Radiance = fixed::types::U2F30;

/// Upper limit of near distances: 8 less 1,025 steps of 2^-28.
pub(crate) const NEAR_LIMIT: Length = Length::from_bits(i32::MAX - 1024);

/// Converts `value / 2^exposure` to a factor, rounded half up.
///
/// `value` must be 0 to 2^exposure.
pub(crate) fn factor(value: Real, exposure: u8) -> Factor {
    // Q32 -> Q15
    let shift = 17 + u32::from(exposure);
    Factor::from_bits(((value.to_bits() + (1 << (shift - 1))) >> shift) as u16)
}

/// Converts `value / 2^exposure` to a radiance, rounded down.
///
/// `value` must be 0 to just below 4 * 2^exposure.
pub(crate) fn radiance(value: Real, exposure: u8) -> Radiance {
    // Q32 -> Q30
    Radiance::from_bits((value.to_bits() >> (2 + exposure)) as u32)
}

/// Converts a number from 0 to 1 to a weight: exact below 1, and 1 - 2^-32 for 1.
pub(crate) fn weight(value: Real) -> Weight {
    Weight::from_bits(u32::try_from(value.to_bits()).unwrap_or(u32::MAX))
}
