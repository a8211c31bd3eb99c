//! Number formats, and the roots and reciprocals that all else is built on.
//!
//! | format | is | range | step |
//! |---|---|---|---|
//! | [`Real`] | authored numbers | ±2^31 | 2^-32 |
//! | [`Length`] | positions and distances of a prepared scene | ±8 | 2^-28 |
//! | [`Unit`] | components of unit vectors, cosines | ±2 | 2^-30 |
//! | [`Factor`] | coefficients, light colors | 0 to 1 | 2^-15 |
//! | [`Intensity`] | cosines and highlights, as light is shaded by them | 0 to 1 | 2^-16 |
//! | [`Weight`] | shares of rays in a pixel | 0 to 1 | 2^-32 |
//! | [`Radiance`] | what comes back along a ray | 0 to 4 | 2^-30 |
//!
//! No operation divides: the M0+ has no divider. A reciprocal and a reciprocal
//! root start from a table of quadratics that is exact to 2^-17 and take one
//! Newton step. The tables are computed by the compiler, in integers.

use super::product::Product;
use long_multiply::{by_16_bits, square_of_21_bits};
pub(crate) use long_multiply::{leading_zeros, middle, rounded};

/// An authored number: the range and precision of a scene as it is written
/// down, ±2^31 in steps of 2^-32.
pub type Real = fixed::types::I32F32;

/// A position or a distance in a prepared scene, whose finite geometry lies
/// within ±1: ±8 in steps of 2^-28.
pub(crate) type Length = fixed::types::I4F28;

/// A component of a unit vector or a cosine: ±2 in steps of 2^-30.
pub(crate) type Unit = fixed::types::I2F30;

/// A coefficient or the color of a light: 0 to 1 in steps of 2^-15.
///
/// Sixteen bits, so that the product of two fits a 32-bit multiply.
pub(crate) type Factor = fixed::types::U1F15;

/// How bright something is lit: 0 to 1 in steps of 2^-16.
///
/// The product of a factor and it fits 32 bits.
pub(crate) type Intensity = fixed::types::U16F16;

/// How much of what a ray brings back reaches the eye: 0 to 1 in steps of 2^-32, the last
/// of which stands for 1 itself.
///
/// The upper word of its product with a radiance is a radiance.
pub(crate) type Weight = fixed::types::U0F32;

/// Linear radiance of one channel: 0 to just below 4 in steps of 2^-30,
/// saturating. White is 1.
pub type Radiance = fixed::types::U2F30;

/// Distances below it are near; just below 8.
pub(crate) const NEAR_LIMIT: Length = Length::from_bits(i32::MAX - 1024);

/// A number of 0 to 2^exposure as a factor, rounded.
pub(crate) fn factor(value: Real, exposure: u8) -> Factor {
    let shift = 17 + u32::from(exposure);
    Factor::from_bits(((value.to_bits() + (1 << (shift - 1))) >> shift) as u16)
}

/// A number of 0 to 4 * 2^exposure as a radiance, rounded down.
pub(crate) fn radiance(value: Real, exposure: u8) -> Radiance {
    Radiance::from_bits((value.to_bits() >> (2 + exposure)) as u32)
}

/// A number of 0 to 1 as a weight.
pub(crate) fn weight(value: Real) -> Weight {
    Weight::from_bits(u32::try_from(value.to_bits()).unwrap_or(u32::MAX))
}

/// A positive number as `mantissa * 2^exponent`, the mantissa's top bit set.
///
/// The order is that of the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct SoftFloat {
    pub(crate) exponent: i32,
    pub(crate) mantissa: u32,
}

impl SoftFloat {
    /// Nothing at all.
    pub(crate) const ZERO: Self = Self {
        mantissa: 0,
        exponent: -64,
    };

    /// A distance that is not negative, as [`Ray::far_at`](crate::ray::Ray::far_at) takes
    /// it: not shifted up, and so in no order with others.
    pub(crate) fn unordered(distance: Length) -> Self {
        Self {
            mantissa: distance.to_bits() as u32,
            exponent: 0,
        }
    }

    /// The number as a distance, rounded, if it is below [`NEAR_LIMIT`].
    #[inline]
    pub(crate) fn near(self) -> Option<Length> {
        let shift = self.exponent.checked_neg()?.checked_sub(1)?;
        let half = self.mantissa.checked_shr(u32::try_from(shift).ok()?);
        let half = half.unwrap_or(0);
        let rounded = (half >> 1) + (half & 1);
        (rounded < NEAR_LIMIT.to_bits() as u32).then_some(Length::from_bits(rounded as i32))
    }

    /// The number as an integer; it must fit.
    pub(crate) fn to_bits(self) -> i64 {
        let mantissa = i64::from(self.mantissa);
        if self.exponent < 0 {
            mantissa >> (-self.exponent).min(63)
        } else {
            mantissa << self.exponent
        }
    }
}

/// The upper word of a number above 0 once it is shifted up by as many bits as
/// there are free, and by how many that is.
#[inline(always)]
fn shifted_up(x: u64) -> (u32, u32) {
    let (mut high, mut low, mut shift) = ((x >> 32) as u32, x as u32, 0);
    if high == 0 {
        (high, low, shift) = (scarce(low), 0, 32);
    }
    let up = leading_zeros(high);
    (shifted(high, low, up), shift + up)
}

/// The upper one of two words, shifted up by 0 to 31 bits: by shifts of words, as those
/// of 64 bits are calls on the M0+.
#[inline(always)]
fn shifted(high: u32, low: u32, up: u32) -> u32 {
    high << up | (low >> 1) >> (31 - up)
}

/// Few numbers are so small, and a test costs less than to count them in.
#[cold]
#[inline(never)]
fn scarce(low: u32) -> u32 {
    low.max(1)
}

/// `2^30 n / d` for numbers above 0, relative error below 2^-29.
///
/// The quotient of Q58 by Q60, of Q56 by Q58 or of Q28 by Q30 is then in steps
/// of 2^-28.
#[inline]
pub(crate) fn quotient(n: u64, d: u64) -> SoftFloat {
    let ((n, n_shift), (d, d_shift)) = (shifted_up(n), shifted_up(d));
    let (mantissa, last) = shifted_up(wide(n, reciprocal(d | 1 << 31)));
    // n = mantissa * 2^(32 - n_shift), 1/d = reciprocal * 2^(d_shift - 95) and
    // product = the quotient's mantissa * 2^(32 - last).
    SoftFloat {
        mantissa,
        exponent: d_shift as i32 - n_shift as i32 - last as i32 - 1,
    }
}

/// The upper half of the product of two numbers, `a b / 2^64`, with a relative
/// error below 2^-30; shifted left by `shift`.
#[inline(never)]
pub(crate) fn upper_product(a: u64, b: u64, shift: u32) -> u64 {
    let ((a, a_shift), (b, b_shift)) = (shifted_up(a), shifted_up(b));
    let product = wide(a, b);
    let down = (a_shift + b_shift) as i32 - shift as i32;
    if down >= 0 {
        product.checked_shr(down as u32).unwrap_or(0)
    } else {
        product << -down
    }
}

/// A table has 32 segments for each factor of two, or what is left of it.
const SEGMENTS: usize = 32;

/// Up to 1, of which the first quarter is not used: no index is out of range.
const ROOT_SEGMENTS: usize = 64;

/// A quadratic through the two ends and the middle of a segment, in 2^-20.
type Quadratic = [i32; 3];

const fn quadratic(start: u64, middle: u64, end: u64) -> Quadratic {
    let (c0, middle, end) = (start as i32, middle as i32, end as i32);
    [c0, 4 * middle - 3 * c0 - end, 2 * (c0 + end) - 4 * middle]
}

/// 1/x in 2^-20, x in 2^-10.
const fn reciprocal_at(x: u64) -> u64 {
    below_two(((1 << 31) / x).div_ceil(2))
}

/// 1/sqrt(x) in 2^-20, x in 2^-10.
const fn reciprocal_root_at(x: u64) -> u64 {
    below_two(((1 << 62) / x).isqrt().div_ceil(1 << 6))
}

/// What fits `U1F31` once shifted.
const fn below_two(x: u64) -> u64 {
    if x >> 21 == 0 { x } else { (1 << 21) - 1 }
}

/// Of 1/x over [1/2, 1), by the five bits below the top one.
static RECIPROCAL: [Quadratic; SEGMENTS] = {
    let mut table = [[0; 3]; SEGMENTS];
    let mut i = 0;
    while i < SEGMENTS {
        let x = 512 + 16 * i as u64;
        table[i] = quadratic(
            reciprocal_at(x),
            reciprocal_at(x + 8),
            reciprocal_at(x + 16),
        );
        i += 1;
    }
    table
};

/// Of 1/sqrt(x) over [1/4, 1), by the top six bits.
static RECIPROCAL_ROOT: [Quadratic; ROOT_SEGMENTS] = {
    let mut table = [[0; 3]; ROOT_SEGMENTS];
    let mut i = ROOT_SEGMENTS / 4;
    while i < ROOT_SEGMENTS {
        let x = 16 * i as u64;
        table[i] = quadratic(
            reciprocal_root_at(x),
            reciprocal_root_at(x + 8),
            reciprocal_root_at(x + 16),
        );
        i += 1;
    }
    table
};

/// The quadratic at `x`, the next 14 bits of the argument.
#[inline(always)]
fn evaluate([c0, c1, c2]: Quadratic, x: i32) -> u32 {
    (c0 + (((c1 + ((c2 * x) >> 14)) * x) >> 14)) as u32
}

/// 1/x for x in [1/2, 1) as `U0F32`: in (1, 2] as `U1F31`.
///
/// Relative error below 2^-30.
#[inline]
pub(crate) fn reciprocal(x: u32) -> u32 {
    debug_assert!(x >> 31 == 1);
    let segment = RECIPROCAL[(x >> 26) as usize & (SEGMENTS - 1)];
    let y = evaluate(segment, (x >> 12) as i32 & 0x3fff);
    // e = 1 - x*y: U0F32 * U1F31 -> Q63, and |e| < 2^-16 leaves 47 bits of it.
    let error = !middle(x, y << 11) as i32;
    // y + y*e: U1F31 * Q47 -> U1F31
    refined(y, error)
}

/// 1/sqrt(x) for x in [1/4, 1) as `U0F32`: in (1, 2] as `U1F31`.
///
/// Relative error below 2^-30.
#[inline]
pub(crate) fn reciprocal_root(x: u32) -> u32 {
    debug_assert!(x >> 30 != 0);
    let segment = RECIPROCAL_ROOT[(x >> 26) as usize];
    let y = evaluate(segment, (x >> 12) as i32 & 0x3fff);
    // e = 1 - x*y*y: U1F20^2 -> U2F30, * U0F32 -> Q62, and |e| < 2^-15 leaves 48 bits of it.
    let error = !middle(x, square_of_21_bits(y)) as i32;
    // y + y*e/2: U1F31 * Q46 -> U1F31
    refined(y, error)
}

/// Newton's step from `y`, in 2^-20, to `y + y * error`, in 2^-31; the error
/// in 2^-47. It never leads beyond the true value, and so stays below 2.
#[inline(always)]
fn refined(y: u32, error: i32) -> u32 {
    // The step is below 2^-15 of `y`: 16 bits of that are enough.
    (y << 11).wrapping_add_signed(by_16_bits(y >> 5, error))
}

/// The full product of two words.
#[inline(always)]
pub(crate) fn wide(a: u32, b: u32) -> u64 {
    a.product(b)
}

/// 1/sqrt(x): `x` is an integer, and the result in units of 2^-32 times the
/// scaled mantissa. A zero counts as one.
#[inline]
pub(crate) fn inverse_length(square: u64) -> InverseLength {
    let (high, low) = ((square >> 32) as u32, square as u32);
    if high == 0 {
        return super::outlined::inverse_length_of_word(low);
    }
    inverse_length_of(high, low)
}

/// The same of the two words of a number from 2^32.
#[inline(always)]
pub(super) fn inverse_length_of(high: u32, low: u32) -> InverseLength {
    let up = leading_zeros(high) & 30;
    let normalized = shifted(high, low, up);
    InverseLength {
        normalized,
        inverse: reciprocal_root(normalized),
        half_shift: up / 2,
    }
}

/// The reciprocal root of an integer `n`, scaled so that
/// `n = normalized * 2^(32 - 2*half_shift)`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InverseLength {
    /// `U0F32` in [1/4, 1).
    pub(crate) normalized: u32,
    /// Its reciprocal root, `U1F31`.
    pub(crate) inverse: u32,
    pub(crate) half_shift: u32,
}

impl InverseLength {
    /// The cosine of a vector, whose length this is the reciprocal of, to a direction: from
    /// how long it is along that, in steps 2^30 times as fine. Error below 2^-28.
    #[inline(always)]
    pub(crate) fn cosine(self, along: i64) -> Unit {
        // Below 2^30, as the length is below 2^(32 - half_shift).
        let (high, low) = ((along >> 32) as i32, along as u32);
        let scaled = high << self.half_shift | ((low >> 1) >> (31 - self.half_shift)) as i32;
        // * U1F31, which less 2 fits a signed word, for which chips have a multiply.
        let product = long_multiply::upper(scaled, self.inverse as i32);
        Unit::from_bits((scaled << 1).wrapping_add(product))
    }

    /// sqrt(n), relative error below 2^-29, rounded to an integer.
    #[inline]
    pub(crate) fn length(self) -> u32 {
        // U0F32 * U1F31 -> Q63 in [1/2, 1), times 2^(32 - half_shift)
        let root = wide(self.normalized, self.inverse);
        if self.half_shift < 2 {
            let shift = 31 + self.half_shift;
            return ((root + (1 << (shift - 1))) >> shift).min(u64::from(u32::MAX)) as u32;
        }
        let twice = (root >> 32) as u32 >> (self.half_shift - 2);
        (twice + 1) >> 1
    }
}

/// sqrt(x), rounded, relative error below 2^-29: of a square in steps of
/// 2^-2k, the root in steps of 2^-k.
#[inline(never)]
pub(crate) fn square_root(x: u64) -> u32 {
    if x == 0 {
        0
    } else {
        super::outlined::inverse_length(x).length()
    }
}

/// base^exponent for a base of 0 to 1 as `U1F31` and an exponent from 1 as
/// `U16F16`: as `U1F31`.
///
/// By squaring for the integer part of the exponent and by roots for its
/// fraction. The error is below 2^-30 times the exponent plus 16.
#[inline(never)]
pub(crate) fn power(base: u32, exponent: u32) -> u32 {
    const ONE: u32 = 1 << 31;
    // U1F31 * U1F31 -> U1F31, rounded
    let multiply = |a, b| ((wide(a, b) + (1 << 30)) >> 31) as u32;
    let mut result = ONE;
    let mut square = base;
    let mut integer = exponent >> 16;
    loop {
        if integer & 1 == 1 {
            result = multiply(result, square);
        }
        integer >>= 1;
        if integer == 0 {
            break;
        }
        square = multiply(square, square);
        if square == 0 {
            return 0;
        }
    }
    let mut root = base;
    let mut fraction = exponent << 16;
    while fraction != 0 {
        // sqrt of 2^-62 is in 2^-31
        root = square_root(u64::from(root) << 31);
        if fraction >> 31 == 1 {
            result = multiply(result, root);
        }
        fraction <<= 1;
    }
    result
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;

    /// Every exponent and segment, both ends of each, and a million between.
    fn words() -> impl Iterator<Item = u32> {
        let edges = (0..32).flat_map(|bit| {
            let x = 1_u32 << bit;
            [x, x.wrapping_sub(1), x + 1, !x]
        });
        let segments = (0..64_u32).flat_map(|i| {
            let x = i << 26;
            [x, x.wrapping_sub(1), x + 1, x + (1 << 25)]
        });
        let mut state = 1_u32;
        // Miri takes a thousand times as long for each.
        let random = (0..if cfg!(miri) { 200 } else { 1_000_000 }).map(move |_| {
            state ^= state << 13;
            state ^= state >> 17;
            state ^= state << 5;
            state
        });
        edges.chain(segments).chain(random)
    }

    /// Prints the largest error as a share of its bound, and checks it.
    fn hold(what: &str, shares: impl Iterator<Item = f64>) {
        let largest = shares.map(f64::abs).fold(0.0, f64::max);
        std::println!("{what}: {largest:.2} of the bound");
        assert!(largest < 1.0, "{what}: {largest}");
    }

    #[test]
    fn reciprocals_hold_their_bound() {
        let share = |word| {
            let x = word | 1 << 31;
            let exact = 2_f64.powi(63) / f64::from(x);
            (f64::from(reciprocal(x)) - exact) / exact * 2_f64.powi(30)
        };
        hold("reciprocal", words().map(share));
    }

    #[test]
    fn reciprocal_roots_hold_their_bound() {
        let share = |x| {
            let exact = 2_f64.powi(31) / (f64::from(x) / 2_f64.powi(32)).sqrt();
            (f64::from(reciprocal_root(x)) - exact) / exact * 2_f64.powi(30)
        };
        let both = words().flat_map(|word| [word | 1 << 31, word >> 1 | 1 << 30]);
        hold("reciprocal root", both.map(share));
    }

    #[test]
    fn square_roots_hold_their_bound() {
        let pairs = words().zip(words().skip(1));
        let numbers = pairs.flat_map(|(high, low)| {
            let x = u64::from(high) << 32 | u64::from(low);
            [x, x >> 17, x >> 32, x >> 60]
        });
        let share = |x| {
            let exact = (x as f64).sqrt();
            let error = f64::from(square_root(x)) - exact;
            error / (0.5 + exact * 2_f64.powi(-29))
        };
        hold("square root", numbers.map(share));
    }

    #[test]
    fn cosines_hold_their_bound() {
        let cases = words().zip(words().skip(9)).zip(words().skip(5));
        let cosines = cases.map(|((high, low), part)| {
            // The square of a length below 8, and how much of that is along.
            let square = (u64::from(high) << 32 | u64::from(low)) >> (2 + (part & 31));
            let length = (square as f64).sqrt();
            let share = f64::from(part as i32) / 2_f64.powi(31);
            let along = (share * length * 2_f64.powi(30)) as i64;
            let exact = along as f64 / length.max(1.0);
            let cosine = inverse_length(square).cosine(along);
            (f64::from(cosine.to_bits()) - exact) / 4.0
        });
        hold("cosine", cosines);
    }

    #[test]
    fn powers_hold_their_bound() {
        let cases = words().zip(words().skip(7)).take(100_000);
        let cases = cases.flat_map(|(base, exponent)| {
            let exponent = exponent | 1 << 31;
            [exponent >> 4, exponent >> 9, exponent >> 15, 1 << 28]
                .map(|exponent| (base >> 1, exponent))
        });
        let share = |(base, exponent)| {
            let s = f64::from(exponent) / 65536.0;
            let exact = (f64::from(base) / 2_f64.powi(31)).powf(s);
            let error = f64::from(power(base, exponent)) / 2_f64.powi(31) - exact;
            error / (2_f64.powi(-30) * (s + 16.0))
        };
        hold("power", cases.map(share));
    }

    #[test]
    fn quotients_and_upper_products_hold_their_bound() {
        let numbers = || {
            let pairs = words().zip(words().skip(3));
            pairs.map(|(high, low)| (u64::from(high) << 32 | u64::from(low)) >> (low & 31) | 1)
        };
        let pairs = || numbers().zip(numbers().skip(5));
        let value = |x: SoftFloat| f64::from(x.mantissa) * 2_f64.powi(x.exponent);
        let quotients = pairs().map(|(n, d)| {
            let exact = n as f64 / d as f64 * 2_f64.powi(30);
            (value(quotient(n, d)) - exact) / exact * 2_f64.powi(29)
        });
        hold("quotient", quotients);
        let products = pairs().map(|(a, b)| {
            let exact = a as f64 * b as f64 * 2_f64.powi(-64);
            let error = upper_product(a, b, 0) as f64 - exact;
            error / (1.0 + exact * 2_f64.powi(-30))
        });
        hold("upper product", products);
    }
}
