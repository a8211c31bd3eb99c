//! Transfer functions convert linear radiance to display values. The greatest display value is
//! 2^16.

use crate::math::Radiance;
use crate::scene::Transfer;

impl Transfer {
    /// Clips a radiance to 0..=1 and converts it to a display value from 0 to 2^16.
    #[inline(always)]
    pub(crate) fn encode(self, light: Radiance) -> u32 {
        let light = light.to_bits().min(1 << 30);
        match self {
            // The shift rounds Q30 down to Q16. The error is at most 1/256 of an 8-bit level.
            Self::Linear => light >> 14,
            Self::Srgb => srgb(light),
        }
    }
}

/// Number of table segments for each factor of two of the radiance, for example from 1/2 to 1.
const SEGMENTS: u32 = 8;

/// The smallest radiance in the table is 2^-9, which is `1 << FIRST` in Q30. Below 2^-9 the
/// encoding is linear and needs no table.
const FIRST: u32 = 21;

/// Number of table entries: one for each segment from 2^-9 to 1, and one for the radiance 1.
const ENTRIES: usize = (SEGMENTS * (30 - FIRST)) as usize + 1;

/// Encodes a radiance as sRGB by linear interpolation in a table. The radiance is from 0 to 1, in
/// Q30. The result is in Q16. The error of the result is below 0.1 of an 8-bit level (measured:
/// 0.09).
///
/// The function is not inlined, so that the calls for the three channels share one copy of the
/// code.
#[inline(never)]
fn srgb(light: u32) -> u32 {
    if light >> FIRST == 0 {
        // Multiplies by 12.92: the product of Q27 and Q10 is shifted to Q16.
        return ((light >> 3) * 13_230) >> 21;
    }
    let exponent = 31 - light.leading_zeros();
    let shift = exponent - SEGMENTS.ilog2();
    // `light >> shift` is from `SEGMENTS` to `2 * SEGMENTS - 1`. Subtracting `SEGMENTS` gives the
    // number of the segment, counted from the power of two at or below `light`.
    let index = SEGMENTS * (exponent - FIRST) + (light >> shift) - SEGMENTS;
    let Some(&[start, rise]) = CHORDS.get(index as usize) else {
        return 1 << 16;
    };
    // `fraction` is the position in the segment, from 0 to 1, in Q15.
    let fraction = (light << (31 - exponent) << 4) >> 17;
    // Both terms have Q30 and are rounded to Q16.
    ((u32::from(start) << 15) + u32::from(rise) * fraction + (1 << 13)) >> 14
}

/// For each segment, the sRGB value at its start and the increase of this value over the segment.
/// The two numbers are in Q15.
static CHORDS: [[u16; 2]; ENTRIES] = {
    let mut chords = [[0; 2]; ENTRIES];
    let mut index = 0;
    while index < ENTRIES {
        let start = encoded(index as u32);
        chords[index] = [start, encoded(index as u32 + 1) - start];
        index += 1;
    }
    // The last entry is for the radiance 1. Radiances are clipped to 1, so the value does not
    // increase further.
    chords[ENTRIES - 1][1] = 0;
    chords
};

/// Returns the sRGB value, in Q15, of the radiance x at which segment `index` starts. The value is
/// `12.92 x` up to x = 0.0031308. For greater x, it is `1.055 x^(1 / 2.4) - 0.055`.
const fn encoded(index: u32) -> u16 {
    // The radiance x in Q12.
    let light = ((SEGMENTS + index % SEGMENTS) << (index / SEGMENTS)) as u128;
    if light * 10_000_000 < 31_308 << 12 {
        return ((light * 1292 * 8 + 50) / 100) as u16;
    }
    // Computes x^(1 / 2.4) in Q32 as x^(5/12). First takes the cube root of x^5, in Q40, and then
    // takes the square root twice.
    let root = cube_root(light.pow(5) << 60);
    let power = ((root << 24).isqrt() << 32).isqrt();
    (((power * 1055 - (55 << 32)) / 1000 + (1 << 16)) >> 17) as u16
}

/// Returns the cube root of a number below 2^123, rounded down.
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

    /// Returns the sRGB value of a radiance by the formula of IEC 61966-2-1.
    fn exact(light: f64) -> f64 {
        if light <= 0.003_130_8 {
            12.92 * light
        } else {
            1.055 * light.powf(1.0 / 2.4) - 0.055
        }
    }

    #[test]
    fn srgb_is_monotonic_and_within_a_tenth_of_an_8_bit_level() {
        let (mut worst, mut last) = (0.0_f64, 0);
        let all = (0..=1 << 30).step_by(67).chain([1 << 30]);
        for light in all {
            let shown = Transfer::Srgb.encode(Radiance::from_bits(light));
            assert!(shown >= last, "{light}: the encoding decreases");
            last = shown;
            let exact = exact(f64::from(light) / f64::from(1 << 30));
            worst = worst.max((f64::from(shown) / 65_536.0 - exact).abs() * 255.0);
        }
        println!("sRGB: {worst:.3} of an 8-bit level");
        assert!(worst < 0.1, "{worst} of a level");
        assert_eq!(last, 1 << 16);
    }

    #[test]
    fn radiance_is_clipped() {
        for transfer in [Transfer::Linear, Transfer::Srgb] {
            assert_eq!(transfer.encode(Radiance::ZERO), 0);
            assert_eq!(transfer.encode(Radiance::ONE), 1 << 16);
            assert_eq!(transfer.encode(Radiance::MAX), 1 << 16);
        }
    }
}
