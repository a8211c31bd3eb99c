//! Linear colors and arithmetic on their channels.

use long_multiply::by_17_bits;

use super::format::{Factor, Intensity, Radiance, Real, Weight};
use super::product::wide;

/// A linear color: red, green, blue.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Color<T> {
    /// Red channel.
    pub r: T,
    /// Green channel.
    pub g: T,
    /// Blue channel.
    pub b: T,
}

impl<T> Color<T> {
    /// Creates the color (r, g, b).
    pub const fn new(r: T, g: T, b: T) -> Self {
        Self { r, g, b }
    }

    /// Applies `f` to each channel.
    #[inline(always)]
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Color<U> {
        Color::new(f(self.r), f(self.g), f(self.b))
    }

    /// Combines two colors channel by channel.
    #[inline(always)]
    pub(crate) fn zip<U, V>(self, other: Color<U>, f: impl Fn(T, U) -> V) -> Color<V> {
        Color::new(f(self.r, other.r), f(self.g, other.g), f(self.b, other.b))
    }

    /// Returns true if `f` holds for all three channels.
    #[inline(always)]
    pub(crate) fn all(self, f: impl Fn(T) -> bool) -> bool {
        f(self.r) && f(self.g) && f(self.b)
    }
}

impl Color<Real> {
    /// Creates a gray with `value` in each channel.
    pub const fn gray(value: Real) -> Self {
        Self::new(value, value, value)
    }

    /// Parses a color: `Color::lit("0.16", "0.33", "0.68")`. Use the macro
    /// [`color!`](crate::color!) unless the texts are in variables.
    ///
    /// In a constant, a malformed literal is a compile error. Outside of constants, the function
    /// links a parser of 42 KB, and panics if a text is malformed.
    pub const fn lit(r: &str, g: &str, b: &str) -> Self {
        Self::new(Real::lit(r), Real::lit(g), Real::lit(b))
    }
}

/// Returns the product of two factors, rounded half up: `U1F15 * U1F15 -> U1F15`.
///
/// One 32-bit multiply is enough, because a factor is at most 1, which has the bits 2^15.
#[inline(always)]
fn multiply(a: Factor, b: Factor) -> Factor {
    Factor::from_bits(((u32::from(a.to_bits()) * u32::from(b.to_bits()) + (1 << 14)) >> 15) as u16)
}

impl Color<Factor> {
    pub(crate) const WHITE: Self = Self::new(Factor::ONE, Factor::ONE, Factor::ONE);
    pub(crate) const BLACK: Self = Self::new(Factor::ZERO, Factor::ZERO, Factor::ZERO);

    /// Returns true if all channels are 0.
    #[inline(always)]
    pub(crate) fn is_black(self) -> bool {
        self.all(|c| c == Factor::ZERO)
    }

    /// Multiplies two colors channel by channel. The products are rounded half up.
    #[inline(always)]
    pub(crate) fn filtered(self, filter: Self) -> Self {
        self.zip(filter, multiply)
    }

    /// Returns the light that a surface reflects. In each channel, the surface has a coefficient,
    /// which is in `self`. The result is `coefficient * intensity * light`, rounded down to 2^-29,
    /// and is at most 1.
    ///
    /// The product of the two factors has Q30. The product with the intensity is cut to Q29, then
    /// converted to `U2F30`.
    #[inline(always)]
    pub(crate) fn reflect(self, intensity: Intensity, light: Self) -> Color<Radiance> {
        self.zip(light, |coefficient, light| {
            let most = u32::from(coefficient.to_bits()).wrapping_mul(light.to_bits().into());
            Radiance::from_bits(by_17_bits(intensity.to_bits(), most) << 1)
        })
    }
}

impl Color<Weight> {
    /// The full weight. Each channel has the greatest weight, 1 - 2^-32, which stands for 1.
    pub(crate) const ALL: Self = Self::new(Weight::MAX, Weight::MAX, Weight::MAX);
    pub(crate) const BLACK: Self = Self::new(Weight::ZERO, Weight::ZERO, Weight::ZERO);

    /// Returns true if all channels are 0.
    #[inline(always)]
    pub(crate) fn is_black(self) -> bool {
        self.all(|c| c == Weight::ZERO)
    }

    /// Multiplies two weights channel by channel. The products are rounded down:
    /// `U0F32 * U0F32 -> U0F32`.
    #[inline(always)]
    pub(crate) fn shared(self, share: Self) -> Self {
        self.zip(share, |weight, share| {
            Weight::from_bits((wide(weight.to_bits(), share.to_bits()) >> 32) as u32)
        })
    }

    /// Converts the weights to factors: `U0F32 -> U1F15`, rounded half up. A full weight becomes 1.
    pub(crate) fn narrowed(self) -> Color<Factor> {
        self.map(|c| Factor::from_bits(((c.to_bits() >> 16).wrapping_add(1) >> 1) as u16))
    }

    /// Multiplies each channel of a radiance by the weight of that channel. The products are
    /// rounded down: `U0F32 * U2F30 -> U2F30`.
    #[inline(always)]
    pub(crate) fn weigh(self, radiance: Color<Radiance>) -> Color<Radiance> {
        self.zip(radiance, |weight, radiance| {
            Radiance::from_bits((wide(weight.to_bits(), radiance.to_bits()) >> 32) as u32)
        })
    }
}

impl Color<Radiance> {
    pub(crate) const BLACK: Self = Self::new(Radiance::ZERO, Radiance::ZERO, Radiance::ZERO);

    /// Adds two radiances. If a sum would be 4 or more, it becomes the largest value below 4.
    #[inline(always)]
    pub(crate) fn plus(self, other: Self) -> Self {
        self.zip(other, Radiance::saturating_add)
    }

    /// Multiplies each channel by 2^exponent. If a product would be 4 or more, it becomes the
    /// largest value below 4.
    #[inline(always)]
    pub(crate) fn brightened(self, exponent: u32) -> Self {
        self.map(|c| {
            let bits = c.to_bits();
            Radiance::from_bits(if bits.leading_zeros() < exponent {
                u32::MAX
            } else {
                bits << exponent
            })
        })
    }
}
