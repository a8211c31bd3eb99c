//! The number formats of the library, and functions that convert the numbers of a scene to these
//! formats.
//!
//! | format | used for | range | resolution |
//! |---|---|---|---|
//! | [`Real`] | numbers that describe a scene | ±2^31 | 2^-32 |
//! | [`Length`] | positions and distances in a prepared scene | ±8 | 2^-28 |
//! | [`Unit`] | components of unit vectors, cosines | ±2 | 2^-30 |
//! | [`Factor`] | material coefficients, colors of lights | 0 to 1 | 2^-15 |
//! | [`Intensity`] | cosines and highlights that scale a light | 0 to 1 | 2^-16 |
//! | [`Weight`] | contribution of a ray to its pixel | 0 to 1 | 2^-32 |
//! | [`Radiance`] | light that returns along a ray | 0 to 4 | 2^-30 |

/// A number that describes a scene: ±2^31 with a resolution of 2^-32.
///
/// The macro [`real!`](crate::real!) converts a decimal literal: `real!(0.25)`. `Real::lit` is for
/// constants only. Elsewhere, it links a parser of 42 KB and can panic.
pub type Real = fixed::types::I32F32;

/// A position or distance in a prepared scene: ±8 with a resolution of 2^-28.
///
/// Preparing a scene scales it so that its finite geometry lies within ±1.
pub(crate) type Length = fixed::types::I4F28;

/// A cosine or a component of a unit vector: ±2 with a resolution of 2^-30.
pub(crate) type Unit = fixed::types::I2F30;

/// A material coefficient or one channel of a light: 0 to 1 with a resolution of 2^-15.
///
/// A `Factor` has 16 bits, so the product of two factors needs only a 32-bit multiply.
pub(crate) type Factor = fixed::types::U1F15;

/// A cosine or a highlight that scales a light: 0 to 1 with a resolution of 2^-16.
///
/// The product of an `Intensity` and a [`Factor`] fits in 32 bits.
pub(crate) type Intensity = fixed::types::U16F16;

/// The contribution of a ray to its pixel: 0 to 1 with a resolution of 2^-32.
///
/// The largest weight, 1 - 2^-32, stands for 1. The upper 32 bits of the product of a `Weight` and
/// a [`Radiance`] are a `Radiance`.
pub(crate) type Weight = fixed::types::U0F32;

/// Linear radiance of one channel: 0 to just below 4 with a resolution of 2^-30.
///
/// The radiance of white is 1. A sum of radiances that is too large becomes the largest value.
pub type Radiance = fixed::types::U2F30;

/// Distances below this limit, 8 - 1025 * 2^-28, count as near.
pub(crate) const NEAR_LIMIT: Length = Length::from_bits(i32::MAX - 1024);

/// Converts `value / 2^exposure` to a factor, rounded half up.
///
/// `value` must be from 0 to 2^exposure.
#[inline(never)]
pub(crate) fn factor(value: Real, exposure: u8) -> Factor {
    // The shift divides by 2^exposure and converts Q32 to Q15.
    let shift = 17 + u32::from(exposure);
    Factor::from_bits(((value.to_bits() + (1 << (shift - 1))) >> shift) as u16)
}

/// Converts `value / 2^exposure` to a radiance, rounded down.
///
/// `value` must be from 0 to just below 4 * 2^exposure.
#[inline(never)]
pub(crate) fn radiance(value: Real, exposure: u8) -> Radiance {
    // The shift divides by 2^exposure and converts Q32 to Q30.
    Radiance::from_bits((value.to_bits() >> (2 + exposure)) as u32)
}

/// Converts a number from 0 to 1 to a weight. The number 1 becomes 1 - 2^-32. The conversion of
/// smaller numbers is exact.
pub(crate) fn weight(value: Real) -> Weight {
    Weight::from_bits(u32::try_from(value.to_bits()).unwrap_or(u32::MAX))
}
