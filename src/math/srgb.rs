//! Decoding of sRGB colors (IEC 61966-2-1) to linear colors.

use super::color::Color;
use super::format::Real;

impl Color<Real> {
    /// Creates the linear color of an sRGB color, such as a color picker shows it. The function is
    /// `const`, so the color `#c04020` can be the constant `Color::srgb(0xc0, 0x40, 0x20)`.
    ///
    /// Each channel is rounded to the nearest number.
    ///
    /// ```
    /// use whitted::{Color, color, real};
    ///
    /// assert_eq!(Color::srgb(0, 0, 255), color!(0, 0, 1));
    /// // An sRGB gray of one half reflects about a fifth of the light.
    /// assert_eq!(Color::srgb(128, 128, 128), Color::gray(real!(0.21586050011)));
    /// ```
    pub const fn srgb(r: u8, g: u8, b: u8) -> Self {
        Self::new(linear(r), linear(g), linear(b))
    }
}

/// Returns the linear value of an sRGB level. With c = level / 255, the value is c / 12.92 up to
/// c = 0.04045. For greater c, it is ((c + 0.055) / 1.055)^2.4.
const fn linear(level: u8) -> Real {
    let level = level as u128;
    if level <= 10 {
        // 255 * 12.92 is 16473 / 5. The quotient has Q33, and its last bit rounds it to Q32.
        return half(((5 * level) << 33) / 16_473);
    }
    // (c + 0.055) / 1.055, in Q60.
    let base = ((200 * level + 2_805) << 60) / 53_805;
    let square = product(base, base);
    // x^2.4 is x^2 times the fifth root of x^2. The product is shifted from Q60 to Q33.
    half(product(square, fifth_root(square)) >> 27)
}

/// Divides by two and rounds half up. Converts Q33 to Q32.
const fn half(bits: u128) -> Real {
    Real::from_bits(((bits + 1) >> 1) as i64)
}

/// Returns the product of two numbers from 0 to 1 in Q60, rounded down.
const fn product(a: u128, b: u128) -> u128 {
    (a * b) >> 60
}

/// Returns the fifth root of a number from 0 to 1 in Q60. The root is computed bit by bit, and its
/// error is a few units.
const fn fifth_root(x: u128) -> u128 {
    let (mut root, mut bit) = (0, 1 << 60);
    while bit > 0 {
        let next = root | bit;
        let square = product(next, next);
        if next <= 1 << 60 && product(product(square, square), next) <= x {
            root = next;
        }
        bit >>= 1;
    }
    root
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A natural number of up to 448 bits in 32-bit limbs, the lowest limb first.
    type Natural = [u32; 14];

    fn times(mut number: Natural, factor: u64) -> Natural {
        let (low, high) = (factor & 0xffff_ffff, factor >> 32);
        let mut carry = 0_u128;
        let mut last = 0;
        for limb in &mut number {
            let sum = u128::from(*limb) * u128::from(low) + last * u128::from(high) + carry;
            last = u128::from(*limb);
            *limb = sum as u32;
            carry = sum >> 32;
        }
        number
    }

    fn power(base: u64, exponent: u32, start: Natural) -> Natural {
        (0..exponent).fold(start, |number, _| times(number, base))
    }

    fn one() -> Natural {
        let mut one = [0; 14];
        one[0] = 1;
        one
    }

    /// Returns true if `bits / 2^33` is at most (p / q)^(12/5): if bits^5 * q^12 is at most
    /// p^12 * 2^165.
    fn is_at_most(bits: u64, p: u64, q: u64) -> bool {
        let left = power(bits, 5, power(q, 12, one()));
        let right = power(2, 165, power(p, 12, one()));
        left.iter().rev().le(right.iter().rev())
    }

    /// Checks that no number is nearer to the exact value than the one returned.
    #[test]
    fn every_level_is_rounded_to_nearest() {
        for level in 11..=255 {
            let bits = 2 * linear(level).to_bits() as u64;
            let (p, q) = (200 * u64::from(level) + 2_805, 53_805);
            assert!(is_at_most(bits - 1, p, q), "{level}: too large");
            assert!(!is_at_most(bits + 1, p, q), "{level}: too small");
        }
        for level in 0..=10 {
            let error =
                i128::from(linear(level).to_bits()) * 16_473 - ((5 * i128::from(level)) << 32);
            assert!(2 * error.abs() <= 16_473, "{level}");
        }
    }

    #[test]
    fn ends_are_exact_and_levels_increase() {
        assert_eq!([linear(0), linear(255)], [Real::ZERO, Real::ONE]);
        assert!((0..255).all(|level| linear(level) < linear(level + 1)));
    }
}
