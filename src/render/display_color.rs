//! Conversion of linear radiance to display colors.

use embedded_graphics_core::geometry::Point;
use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666,
    Rgb888, RgbColor,
};

use crate::math::{Color, Radiance};
use crate::render::Output;

/// Color type of a display.
///
/// The RGB, BGR, gray and binary colors of embedded-graphics implement this trait. Their channels
/// are clipped to 0..=1. Gray colors show the luminance that ITU-R BT.709 defines. A binary pixel
/// is on if its dithered luminance rounds to 1. `Color<u16>` also implements this trait, but it is
/// always linear and ignores the [`Output`].
pub trait DisplayColor: Copy {
    /// Converts a linear color to a display color. `at` is the position of the pixel on the
    /// display. The position selects the dithering threshold.
    fn from_radiance(color: Color<Radiance>, at: Point, output: Output) -> Self;
}

/// Returns the luminance of a color as ITU-R BT.709 defines it: 0.2126 R + 0.7152 G + 0.0722 B. The
/// luminance is not clipped.
fn luminance(color: Color<Radiance>) -> Radiance {
    // The weights of the three channels have Q16 and add up to 1.
    let weighted = |value: Radiance, weight: u64| u64::from(value.to_bits()) * weight;
    let sum = weighted(color.r, 13_933) + weighted(color.g, 46_871) + weighted(color.b, 4_732);
    Radiance::from_bits((sum >> 16) as u32)
}

/// A linear color with 16 bits per channel, rounded to nearest. Checksums of pictures and 16-bit
/// images use this color.
impl DisplayColor for Color<u16> {
    fn from_radiance(color: Color<Radiance>, _: Point, _: Output) -> Self {
        color.map(|value| {
            let clipped = u64::from(value.to_bits().min(1 << 30));
            ((clipped * 0xffff + (1 << 29)) >> 30) as u16
        })
    }
}

/// Returns a function that converts the radiance of a color channel to a display level. The
/// function takes the radiance and the greatest level of the channel. `at` is the position of the
/// pixel on the display.
fn levels(at: Point, output: Output, is_coarse: bool) -> impl Fn(Radiance, u8) -> u8 {
    let threshold = output.dither.threshold(at.x, at.y, is_coarse);
    move |light, max| {
        // The product is the level in Q16. Adding the threshold rounds or dithers the level.
        ((output.transfer.encode(light) * u32::from(max) + threshold) >> 16) as u8
    }
}

macro_rules! rgb {
    ($($color:ty),*) => {$(
        impl DisplayColor for $color {
            fn from_radiance(color: Color<Radiance>, at: Point, output: Output) -> Self {
                let level = levels(at, output, Self::MAX_G < u8::MAX);
                Self::new(
                    level(color.r, Self::MAX_R),
                    level(color.g, Self::MAX_G),
                    level(color.b, Self::MAX_B),
                )
            }
        }
    )*};
}

rgb!(
    Rgb555, Rgb565, Rgb666, Rgb888, Bgr555, Bgr565, Bgr666, Bgr888
);

macro_rules! gray {
    ($($color:ty: $max:literal),*) => {$(
        impl DisplayColor for $color {
            fn from_radiance(color: Color<Radiance>, at: Point, output: Output) -> Self {
                Self::new(levels(at, output, $max < 255)(luminance(color), $max))
            }
        }
    )*};
}

gray!(Gray8: 255, Gray4: 15, Gray2: 3);

impl DisplayColor for BinaryColor {
    fn from_radiance(color: Color<Radiance>, at: Point, output: Output) -> Self {
        (levels(at, output, true)(luminance(color), 1) == 1).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::render::Dither;
    use embedded_graphics_core::pixelcolor::GrayColor;

    const NEAREST: Output = Output {
        transfer: crate::render::Transfer::Linear,
        dither: Dither::Off,
    };

    fn gray(value: Radiance) -> Color<Radiance> {
        Color::new(value, value, value)
    }

    fn nearest<P: DisplayColor>(value: Radiance) -> P {
        P::from_radiance(gray(value), Point::zero(), NEAREST)
    }

    #[test]
    fn rounds_and_clips_levels() {
        let half_level = Radiance::ONE / 62;
        let little = Radiance::from_bits(1 << 15);
        assert_eq!(nearest::<Rgb565>(Radiance::MAX), Rgb565::WHITE);
        assert_eq!(nearest::<Rgb565>(half_level + little).r(), 1);
        assert_eq!(nearest::<Rgb565>(half_level - little).r(), 0);
        assert_eq!(nearest::<Gray4>(Radiance::ONE).luma(), 15);
        assert_eq!(nearest::<Gray2>(Radiance::ZERO).luma(), 0);
        let half = Radiance::ONE / 2;
        assert_eq!(nearest::<BinaryColor>(half), BinaryColor::On);
        assert_eq!(nearest::<Color<u16>>(Radiance::ONE).g, 0xffff);
    }

    /// Returns the pixels of a dithered 8x8 tile of uniform gray.
    fn tile<P: DisplayColor>(value: Radiance) -> impl Iterator<Item = P> {
        let places = (0..64).map(|i| Point::new(i % 8 - 4, i / 8));
        places.map(move |at| P::from_radiance(gray(value), at, Output::default()))
    }

    #[test]
    fn mean_of_dithered_tile_equals_value() {
        for share in 0..=64 {
            let value = Radiance::ONE / 64 * share;
            let lit = tile::<BinaryColor>(value).filter(|it| it.is_on()).count();
            assert_eq!(lit, share as usize);
            let sum: u32 = tile::<Gray4>(value).map(|it| u32::from(it.luma())).sum();
            assert_eq!(sum, 15 * share);
        }
    }

    #[test]
    fn does_not_dither_8_bit_channels() {
        let value = Radiance::ONE / 1000 * 123;
        assert!(tile::<Rgb888>(value).all(|it| it == nearest(value)));
        assert!(tile::<Gray8>(value).all(|it| it == nearest(value)));
        assert!(tile::<Color<u16>>(value).all(|it| it == nearest(value)));
        assert!(!tile::<Rgb666>(value).all(|it| it == nearest(value)));
    }

    #[test]
    fn keeps_order_of_channels() {
        let red = Color::new(Radiance::ONE, Radiance::ZERO, Radiance::ZERO);
        fn shown<P: DisplayColor>(color: Color<Radiance>) -> P {
            P::from_radiance(color, Point::new(3, 5), Output::default())
        }
        assert_eq!(shown::<Rgb888>(red), Rgb888::RED);
        assert_eq!(shown::<Bgr888>(red), Bgr888::RED);
        assert_eq!(shown::<Rgb666>(red), Rgb666::RED);
        assert_eq!(shown::<Bgr666>(red), Bgr666::RED);
        assert_eq!(shown::<Rgb565>(red), Rgb565::RED);
        assert_eq!(shown::<Bgr565>(red), Bgr565::RED);
        assert_eq!(shown::<Rgb555>(red), Rgb555::RED);
        assert_eq!(shown::<Bgr555>(red), Bgr555::RED);
        assert_eq!(shown::<Gray8>(red).luma(), 54);
    }
}
