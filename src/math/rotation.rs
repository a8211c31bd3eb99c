//! Rotations, stored as the sine and cosine of their angles. Only this file uses floats.
//!
//! The `micromath` crate approximates sine and cosine by parabolas. The approximation changes the
//! angle by up to 0.002 radians. It uses only sums, products and conversions of `f32` numbers.
//! IEEE 754 defines the results of these operations to the last bit, so the results are the same
//! on every target. Fixed-point code then scales the sine and cosine so that their squares add up
//! to 1. A rotation therefore keeps lengths.

use micromath::F32Ext;

use super::format::{Real, Unit};
use super::product::Product;
use super::unit_vector::direction;
use super::vec3::Vec3;
use super::word::round_unit;

/// A rotation in a plane, stored as the cosine and sine of its angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rotation {
    pub(crate) cos: Unit,
    pub(crate) sin: Unit,
}

impl Rotation {
    /// Rotation by 0 degrees.
    pub(crate) const NONE: Self = Self {
        cos: Unit::ONE,
        sin: Unit::ZERO,
    };

    /// Creates a rotation by any angle in degrees.
    ///
    /// Rotations by multiples of 90 degrees are exact. For other rotations, the error of the angle
    /// is at most 0.11 degrees. The length `sqrt(cos² + sin²)` differs from 1 by less than 2^-29.
    pub(crate) fn by(degrees: Real) -> Self {
        const FULL: i64 = 360 << 32;
        const QUARTER: i64 = FULL / 4;
        let angle = degrees.to_bits().rem_euclid(FULL);
        let quarters = (angle + QUARTER / 2) / QUARTER;
        let Self { cos, sin } = Self::by_less(angle - quarters * QUARTER);
        match quarters & 3 {
            0 => Self { cos, sin },
            1 => Self {
                cos: -sin,
                sin: cos,
            },
            2 => Self {
                cos: -cos,
                sin: -sin,
            },
            _ => Self {
                cos: sin,
                sin: -cos,
            },
        }
    }

    /// Creates a rotation by an angle from -45 to 45 degrees. `angle` is a number of degrees in
    /// Q32.
    fn by_less(angle: i64) -> Self {
        #![allow(clippy::float_arithmetic, reason = "the library's only floats")]
        const RADIAN: f32 = core::f32::consts::PI / 180.0 / (1_u64 << 32) as f32;
        const ONE: f32 = (1 << 30) as f32;
        let radians = angle.unsigned_abs() as f32 * RADIAN;
        let cos = (F32Ext::cos(radians) * ONE) as i64;
        let sin = (F32Ext::sin(radians) * ONE) as i64 * angle.signum();
        direction(Vec3::new(cos, sin, 0)).map_or(Self::NONE, |unit| Self {
            cos: unit.x,
            sin: unit.y,
        })
    }

    /// Returns the rotation by the sum of the two angles. The sine and cosine of the sum are
    /// computed in Q60 and rounded half up to Q30.
    pub(crate) fn then(self, next: Self) -> Self {
        let cos = self.cos.product(next.cos) - self.sin.product(next.sin);
        let sin = self.sin.product(next.cos) + self.cos.product(next.sin);
        Self {
            cos: round_unit::<30>(cos.to_bits()),
            sin: round_unit::<30>(sin.to_bits()),
        }
    }

    /// Returns the rotation by the negative angle.
    pub(crate) fn back(self) -> Self {
        Self {
            sin: -self.sin,
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;
    use super::*;

    fn angle(turn: Rotation) -> f64 {
        let [cos, sin] = [turn.cos, turn.sin].map(|c| c.to_num::<f64>());
        sin.atan2(cos).to_degrees()
    }

    #[test]
    fn angles_and_lengths_are_within_their_bounds() {
        // Miri runs this test a thousand times slower, so the test checks fewer angles in Miri.
        for tenths in (-7200..7200).step_by(if cfg!(miri) { 97 } else { 1 }) {
            let degrees = f64::from(tenths) / 10.0;
            let turn = Rotation::by(Real::from_num(degrees));
            let off = (angle(turn) - degrees + 180.0).rem_euclid(360.0) - 180.0;
            assert!(off.abs() < 0.11, "{degrees}: off by {off} degrees");
            let [cos, sin] = [turn.cos, turn.sin].map(|c| c.to_num::<f64>());
            let length = cos.hypot(sin);
            assert!((length - 1.0).abs() < 2_f64.powi(-29), "{degrees}");
        }
    }

    #[test]
    fn multiples_of_90_degrees_are_exact() {
        let (one, none) = (Unit::ONE, Unit::ZERO);
        let quarters = [[one, none], [none, one], [-one, none], [none, -one]];
        for (i, [cos, sin]) in (-8..8).zip(quarters.into_iter().cycle()) {
            assert_eq!(
                Rotation::by(Real::from(90 * i)),
                Rotation { cos, sin },
                "{i}"
            );
        }
    }

    #[test]
    fn a_rotation_and_its_inverse_cancel() {
        for degrees in (-180..180).step_by(if cfg!(miri) { 7 } else { 1 }) {
            let turn = Rotation::by(Real::from(degrees));
            let none = turn.then(turn.back());
            assert!((none.cos - Unit::ONE).abs() <= 2 * Unit::DELTA);
            assert_eq!(none.sin, Unit::ZERO);
        }
    }
}
