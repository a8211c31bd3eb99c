//! From linear light to the values of displays, as fractions of full scale in
//! steps of 2^-16.

use crate::math::Radiance;

/// From linear light to the values of a display.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Transfer {
    /// Values are linear light.
    #[default]
    Linear,
    /// Values are encoded as a PC's are (IEC 61966-2-1), so that a picture looks
    /// as it would to the eye in place of the camera, on displays made for that
    /// encoding.
    Srgb,
}

impl Transfer {
    /// Light, clipped to 0..=1, as a value of 0 to 2^16.
    #[inline(always)]
    pub(crate) fn encode(self, light: Radiance) -> u32 {
        let light = light.to_bits().min(1 << 30);
        match self {
            // What is cut off is too small to be seen by 8 bits.
            Self::Linear => light >> 14,
            Self::Srgb => srgb(light),
        }
    }
}

/// Each factor of two has so many segments.
const SEGMENTS: u32 = 8;

/// Below 2^-9, where the encoding is linear, there is no table.
const FIRST: u32 = 21;

/// From 2^-9 to 1, and 1 itself.
const ENTRIES: usize = (SEGMENTS * (30 - FIRST)) as usize + 1;

/// The encoding of light of 0 to 1, Q30, by chords; within 0.1/255 (seen 0.09).
#[inline(never)]
fn srgb(light: u32) -> u32 {
    if light >> FIRST == 0 {
        // 12.92: Q27 * Q10 -> Q16
        return ((light >> 3) * 13_230) >> 21;
    }
    let exponent = 31 - light.leading_zeros();
    let shift = exponent - SEGMENTS.ilog2();
    // The top bit of the light counts as one more factor of two.
    let index = SEGMENTS * (exponent - FIRST) + (light >> shift) - SEGMENTS;
    let Some(&[start, rise]) = CHORDS.get(index as usize) else {
        return 1 << 16;
    };
    // How far into the segment, Q15.
    let into = (light << (31 - exponent) << 4) >> 17;
    // Q15 * Q15 -> Q16
    ((u32::from(start) << 15) + u32::from(rise) * into + (1 << 13)) >> 14
}

/// The encoded value at the start of a segment and its rise along it, Q15.
static CHORDS: [[u16; 2]; ENTRIES] = {
    let mut chords = [[0; 2]; ENTRIES];
    let mut index = 0;
    while index < ENTRIES {
        let start = encoded(index as u32);
        chords[index] = [start, encoded(index as u32 + 1) - start];
        index += 1;
    }
    // Nothing is brighter than 1.
    chords[ENTRIES - 1][1] = 0;
    chords
};

/// The encoding at the start of a segment, Q15.
///
/// `12.92 x` up to 0.0031308 and `1.055 x^(1 / 2.4) - 0.055` from there.
const fn encoded(index: u32) -> u16 {
    // In 2^-12.
    let light = ((SEGMENTS + index % SEGMENTS) << (index / SEGMENTS)) as u128;
    if light * 10_000_000 < 31_308 << 12 {
        return ((light * 1292 * 8 + 50) / 100) as u16;
    }
    // x^(5 / 12): the cube root of x^5 in Q40, and of that the root twice, Q32.
    let root = cube_root(light.pow(5) << 60);
    let power = ((root << 24).isqrt() << 32).isqrt();
    (((power * 1055 - (55 << 32)) / 1000 + (1 << 16)) >> 17) as u16
}

/// Rounded down; of a number below 2^123.
const fn cube_root(x: u128) -> u128 {
    let (mut root, mut bit) = (0_u128, 1 << 41);
    while bit > 0 {
        if (root | bit).pow(3) <= x {
            root |= bit;
        }
        bit >>= 1;
    }
    root
}

#[cfg(test)]
mod tests {
    extern crate std;

    use std::println;

    use super::*;

    /// IEC 61966-2-1.
    fn exact(light: f64) -> f64 {
        if light <= 0.003_130_8 {
            12.92 * light
        } else {
            1.055 * light.powf(1.0 / 2.4) - 0.055
        }
    }

    #[test]
    fn srgb_is_within_a_fraction_of_an_8_bit_level() {
        let (mut worst, mut last) = (0.0_f64, 0);
        let all = (0..=1 << 30).step_by(67).chain([1 << 30]);
        for light in all {
            let shown = Transfer::Srgb.encode(Radiance::from_bits(light));
            assert!(shown >= last, "{light}: brighter light is shown darker");
            last = shown;
            let exact = exact(f64::from(light) / f64::from(1 << 30));
            worst = worst.max((f64::from(shown) / 65_536.0 - exact).abs() * 255.0);
        }
        println!("sRGB: {worst:.3} of an 8-bit level");
        assert!(worst < 0.1, "{worst} of a level");
        assert_eq!(last, 1 << 16);
    }

    #[test]
    fn light_is_clipped() {
        for transfer in [Transfer::Linear, Transfer::Srgb] {
            assert_eq!(transfer.encode(Radiance::ZERO), 0);
            assert_eq!(transfer.encode(Radiance::ONE), 1 << 16);
            assert_eq!(transfer.encode(Radiance::MAX), 1 << 16);
        }
    }
}
