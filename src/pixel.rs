//! From linear radiance to the colors of displays.

use embedded_graphics_core::pixelcolor::{
    Bgr565, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb666, Rgb888, RgbColor,
};

use crate::Color;
use crate::num::Radiance;

/// A color that linear radiance can be shown in.
///
/// Channels are clipped to 0..=1 and rounded to the nearest level; there is no
/// gamma, so a display shows linear values as its own. Gray is the luminance
/// of ITU-R BT.709, and a binary pixel is on from one half of it.
pub trait Pixel: Copy {
    /// The nearest color.
    fn from_linear(color: Color<Radiance>) -> Self;
}

/// The nearest of the levels 0 to `max`, which is below 2^16.
#[inline(always)]
fn level(value: Radiance, max: u32) -> u32 {
    // Q30 -> Q16: 1.0 * max fits 32 bits, and what is cut off is too small to
    // be seen by 8 bits.
    let clipped = value.to_bits().min(1 << 30);
    (((clipped >> 14) * max) + (1 << 15)) >> 16
}

/// Luminance by ITU-R BT.709, not clipped: 0.2126 R + 0.7152 G + 0.0722 B.
#[inline(always)]
fn luminance(color: Color<Radiance>) -> Radiance {
    // In 2^-16; they add up to 1.
    let weighted = |value: Radiance, weight: u64| u64::from(value.to_bits()) * weight;
    let sum = weighted(color.r, 13_933) + weighted(color.g, 46_871) + weighted(color.b, 4_732);
    Radiance::from_bits((sum >> 16) as u32)
}

/// Linear, 16 bits a channel, rounded: what checksums and 16-bit images are made of.
impl Pixel for Color<u16> {
    #[inline]
    fn from_linear(color: Color<Radiance>) -> Self {
        color.map(|value| {
            let clipped = u64::from(value.to_bits().min(1 << 30));
            ((clipped * 0xffff + (1 << 29)) >> 30) as u16
        })
    }
}

macro_rules! rgb {
    ($($color:ty),*) => {$(
        impl Pixel for $color {
            #[inline]
            fn from_linear(color: Color<Radiance>) -> Self {
                Self::new(
                    level(color.r, Self::MAX_R.into()) as u8,
                    level(color.g, Self::MAX_G.into()) as u8,
                    level(color.b, Self::MAX_B.into()) as u8,
                )
            }
        }
    )*};
}

rgb!(Rgb565, Rgb666, Rgb888, Bgr565, Bgr888);

macro_rules! gray {
    ($($color:ty: $max:literal),*) => {$(
        impl Pixel for $color {
            #[inline]
            fn from_linear(color: Color<Radiance>) -> Self {
                Self::new(level(luminance(color), $max) as u8)
            }
        }
    )*};
}

gray!(Gray8: 255, Gray4: 15, Gray2: 3);

impl Pixel for BinaryColor {
    #[inline]
    fn from_linear(color: Color<Radiance>) -> Self {
        (luminance(color) >= Radiance::ONE / 2).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use embedded_graphics_core::pixelcolor::GrayColor;

    fn gray(value: Radiance) -> Color<Radiance> {
        Color::new(value, value, value)
    }

    #[test]
    fn levels_are_rounded_and_clipped() {
        let half_level = Radiance::ONE / 62;
        assert_eq!(Rgb565::from_linear(gray(Radiance::MAX)), Rgb565::WHITE);
        assert_eq!(
            Rgb565::from_linear(gray(half_level + Radiance::from_bits(1 << 15))).r(),
            1
        );
        assert_eq!(
            Rgb565::from_linear(gray(half_level - Radiance::from_bits(1 << 15))).r(),
            0
        );
        assert_eq!(Gray4::from_linear(gray(Radiance::ONE)).luma(), 15);
        assert_eq!(Gray2::from_linear(gray(Radiance::ZERO)).luma(), 0);
        assert_eq!(
            BinaryColor::from_linear(gray(Radiance::ONE / 2)),
            BinaryColor::On
        );
        assert_eq!(<Color<u16>>::from_linear(gray(Radiance::ONE)).g, 0xffff);
    }

    #[test]
    fn channels_keep_their_places() {
        let red = Color::new(Radiance::ONE, Radiance::ZERO, Radiance::ZERO);
        assert_eq!(Rgb888::from_linear(red), Rgb888::RED);
        assert_eq!(Bgr888::from_linear(red), Bgr888::RED);
        assert_eq!(Bgr565::from_linear(red), Bgr565::RED);
        assert_eq!(Rgb666::from_linear(red), Rgb666::RED);
        assert_eq!(Gray8::from_linear(red).luma(), 54);
    }
}
