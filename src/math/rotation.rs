//! Angles, as sine and cosine. The only floats of the library are here.
//!
//! micromath's sine and cosine are parabolas, off by up to 0.002 radians; made of
//! sums, products and conversions of `f32` alone, which IEEE 754 defines to the
//! last bit, they are the same on every target. A pair of them is then given
//! unit length in fixed point, so that what is turned keeps its size.

use micromath::F32Ext;

use crate::math::{Product, Real, Unit, Vec3, direction, round_unit};

/// A rotation in a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rotation {
    pub(crate) cos: Unit,
    pub(crate) sin: Unit,
}

impl Rotation {
    pub(crate) const NONE: Self = Self {
        cos: Unit::ONE,
        sin: Unit::ZERO,
    };

    /// By an angle in degrees, any number of times around.
    ///
    /// Multiples of 90 degrees are exact; `cos² + sin²` is 1 to 2^-29.
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

    /// By at most 45 degrees either way, in the bits of a [`Real`].
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

    /// One after the other: the sum of the angles.
    pub(crate) fn then(self, next: Self) -> Self {
        let cos = self.cos.product(next.cos) - self.sin.product(next.sin);
        let sin = self.sin.product(next.cos) + self.cos.product(next.sin);
        // Q60 -> Q30
        Self {
            cos: round_unit::<30>(cos.to_bits()),
            sin: round_unit::<30>(sin.to_bits()),
        }
    }

    /// The same angle, the other way.
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
    fn angles_are_right_and_lengths_are_kept() {
        // Miri takes a thousand times as long for each.
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
    fn quarters_are_exact() {
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
    fn a_turn_and_back_is_none() {
        for degrees in (-180..180).step_by(if cfg!(miri) { 7 } else { 1 }) {
            let turn = Rotation::by(Real::from(degrees));
            let none = turn.then(turn.back());
            assert!((none.cos - Unit::ONE).abs() <= 2 * Unit::DELTA);
            assert_eq!(none.sin, Unit::ZERO);
        }
    }
}
