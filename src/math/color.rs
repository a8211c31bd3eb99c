//! Linear colors, and the products of the formats that tracing uses.

use long_multiply::by_17_bits;

use crate::math::{Factor, Intensity, Radiance, Real, Weight, wide};

/// A linear color: red, green, blue.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Color<T> {
    /// Red.
    pub r: T,
    /// Green.
    pub g: T,
    /// Blue.
    pub b: T,
}

impl<T> Color<T> {
    /// The color (r, g, b).
    pub const fn new(r: T, g: T, b: T) -> Self {
        Self { r, g, b }
    }

    /// The color whose channels are `f` of this one's.
    #[inline(always)]
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Color<U> {
        Color::new(f(self.r), f(self.g), f(self.b))
    }

    #[inline(always)]
    pub(crate) fn zip<U, V>(self, other: Color<U>, f: impl Fn(T, U) -> V) -> Color<V> {
        Color::new(f(self.r, other.r), f(self.g, other.g), f(self.b, other.b))
    }

    /// Whether `f` holds for every channel.
    #[inline(always)]
    pub(crate) fn all(self, f: impl Fn(T) -> bool) -> bool {
        f(self.r) && f(self.g) && f(self.b)
    }
}

impl Color<Real> {
    /// The same in each channel.
    pub const fn gray(value: Real) -> Self {
        Self::new(value, value, value)
    }

    /// A constant, from decimal literals: `Color::lit("0.16", "0.33", "0.68")`.
    ///
    /// In a constant a malformed literal is a compile error.
    pub const fn lit(r: &str, g: &str, b: &str) -> Self {
        Self::new(Real::lit(r), Real::lit(g), Real::lit(b))
    }
}

/// Every product of colors is one 32-bit multiply: factors are at most 2^15.
#[inline(always)]
pub(crate) fn product(a: Factor, b: Factor) -> Factor {
    Factor::from_bits(((u32::from(a.to_bits()) * u32::from(b.to_bits()) + (1 << 14)) >> 15) as u16)
}

impl Color<Factor> {
    pub(crate) const WHITE: Self = Self::new(Factor::ONE, Factor::ONE, Factor::ONE);
    pub(crate) const BLACK: Self = Self::new(Factor::ZERO, Factor::ZERO, Factor::ZERO);

    #[inline(always)]
    pub(crate) fn is_black(self) -> bool {
        self.all(|c| c == Factor::ZERO)
    }

    /// Channel by channel, rounded.
    #[inline(always)]
    pub(crate) fn filtered(self, filter: Self) -> Self {
        self.zip(filter, product)
    }

    /// `coefficient * intensity * color`: what a surface reflects of a light.
    ///
    /// `U1F15 * U1F15 -> Q30, * U16F16 -> Q29 -> U2F30`; never above 1.
    #[inline(always)]
    pub(crate) fn reflect(self, intensity: Intensity, light: Self) -> Color<Radiance> {
        self.zip(light, |coefficient, light| {
            let most = u32::from(coefficient.to_bits()).wrapping_mul(light.to_bits().into());
            Radiance::from_bits(by_17_bits(intensity.to_bits(), most) << 1)
        })
    }
}

impl Color<Weight> {
    pub(crate) const ALL: Self = Self::new(Weight::MAX, Weight::MAX, Weight::MAX);
    pub(crate) const BLACK: Self = Self::new(Weight::ZERO, Weight::ZERO, Weight::ZERO);

    #[inline(always)]
    pub(crate) fn is_black(self) -> bool {
        self.all(|c| c == Weight::ZERO)
    }

    /// The weight of what has a share in it: `U0F32 * U0F32 -> U0F32`.
    #[inline(always)]
    pub(crate) fn shared(self, share: Self) -> Self {
        self.zip(share, |weight, share| {
            Weight::from_bits((wide(weight.to_bits(), share.to_bits()) >> 32) as u32)
        })
    }

    /// As a filter of light: `U0F32 -> U1F15`, rounded.
    pub(crate) fn narrowed(self) -> Color<Factor> {
        self.map(|c| Factor::from_bits(((c.to_bits() >> 16).wrapping_add(1) >> 1) as u16))
    }

    /// `weight * radiance`: `U0F32 * U2F30 -> U2F30`.
    #[inline(always)]
    pub(crate) fn weigh(self, radiance: Color<Radiance>) -> Color<Radiance> {
        self.zip(radiance, |weight, radiance| {
            Radiance::from_bits((wide(weight.to_bits(), radiance.to_bits()) >> 32) as u32)
        })
    }
}

impl Color<Radiance> {
    pub(crate) const BLACK: Self = Self::new(Radiance::ZERO, Radiance::ZERO, Radiance::ZERO);

    /// The sum, saturating just below 4.
    #[inline(always)]
    pub(crate) fn plus(self, other: Self) -> Self {
        self.zip(other, Radiance::saturating_add)
    }

    /// Brighter by a power of two, saturating.
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
