use fixed::types::{I3F29, U0F32, U4F28};

use crate::Vec3;
use crate::num::{Length, Product, Unit, reciprocal};
use crate::vector::round_unit;

use super::super::bound::Bound;
use super::direction::{ASIDE, ELEVATION, EQUATOR};

/// A length in radii of a sphere: ±4 in steps of 2^-29.
pub(crate) type Radii = I3F29;

/// The most generations of smaller spheres.
pub(crate) const MAX_DEPTH: u8 = 8;

/// A sphere of the flake: for each generation, from the first, four bits that
/// tell the child, 1 to 12. The largest sphere is 0.
pub(crate) type Path = u32;

/// What a sphereflake is made of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parts {
    pub(crate) center: Vec3<Length>,
    /// The directions u and v of the largest sphere; w is their cross product.
    pub(crate) frame: [Vec3<Unit>; 2],
    /// Such that all of it is within ±1.
    pub(crate) radius: U0F32,
    /// 0.1 to 0.5.
    pub(crate) ratio: U0F32,
    /// Up to [`MAX_DEPTH`].
    pub(crate) depth: u8,
}

/// A sphereflake.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sphereflake {
    pub(super) center: Vec3<Length>,
    pub(super) frame: [Vec3<Unit>; 2],
    pub(super) radius: U0F32,
    /// `1 / (radius * 2^n)`, with n such that the quotient is 1 to 2: `U1F31`.
    pub(super) inverse_radius: u32,
    pub(super) ratio: U0F32,
    pub(super) inverse_ratio: U4F28,
    pub(super) steps: Steps,
    /// All of it is within so many radii.
    pub(super) bound: Radii,
    pub(super) depth: u8,
}

impl Sphereflake {
    pub(crate) fn new(parts: Parts) -> Self {
        let Parts {
            center,
            frame,
            radius,
            ratio,
            depth,
        } = parts;
        let mantissa = |x: U0F32| x.to_bits().wrapping_shl(x.leading_zeros()) | 1 << 31;
        let inverse = |x| reciprocal(mantissa(x));
        // U1F31 * 2^(n - 3) -> U4F28
        let inverse_ratio = inverse(ratio) >> (3 - ratio.leading_zeros().min(3));
        Self {
            center,
            frame,
            radius,
            inverse_radius: inverse(radius),
            ratio,
            inverse_ratio: U4F28::from_bits(inverse_ratio),
            steps: Steps::new(ratio),
            bound: Self::bound(ratio, depth),
            depth,
        }
    }

    /// What it was made of.
    pub(crate) fn parts(&self) -> Parts {
        Parts {
            center: self.center,
            frame: self.frame,
            radius: self.radius,
            ratio: self.ratio,
            depth: self.depth,
        }
    }

    /// A sphere around all of it.
    pub(crate) fn bounding_sphere(&self) -> Bound {
        // U0F32 * Q29 -> Q61 -> Q28, rounded up.
        let reach = u64::from(self.radius.to_bits()) * self.bound.to_bits() as u64;
        Bound {
            center: self.center,
            radius: Length::from_bits((reach >> 33) as i32 + 1),
        }
    }

    /// How far a flake reaches, in radii, rounded up: a child's center is `1 +
    /// ratio` away, and its own children reach so far in its radii.
    pub(crate) fn bound(ratio: U0F32, depth: u8) -> Radii {
        let ratio = u64::from(ratio.to_bits());
        let one = 1_u64 << 28;
        // U4F28
        let bound = (0..depth).fold(one, |bound, _| {
            one + (ratio >> 4) + ((ratio * bound) >> 32) + 2
        });
        Radii::from_bits((bound as i32 + 1) << 1)
    }

    /// u, v and w of the largest sphere.
    pub(super) fn axes(&self) -> [Vec3<Unit>; 3] {
        let [u, v] = self.frame;
        let w = u.cross(v).map(|c| round_unit(c, 30));
        [u, v, w]
    }
}

/// Directions to children, `1 + ratio` long.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Steps {
    /// From a sphere's center to a child's, in radii: 1.1 to 1.5.
    pub(super) along: Unit,
    equator: Unit,
    aside: Unit,
    elevation: Unit,
}

impl Steps {
    fn new(ratio: U0F32) -> Self {
        let along = Unit::from_bits((1 << 30) + (ratio.to_bits() >> 2) as i32);
        let part = |k: Unit| round_unit(along.product(k).to_bits(), 30);
        Self {
            along,
            equator: part(EQUATOR),
            aside: part(ASIDE),
            elevation: part(ELEVATION),
        }
    }

    /// The dot products with the first six directions, of which the others are
    /// the opposites; shifted right.
    #[inline]
    pub(super) fn dots(&self, v: Vec3<i32>, shift: u32) -> [i32; 6] {
        let part = |c: i32, k: Unit| (c.product(k.to_bits()) >> shift) as i32;
        let x = part(v.x, self.along);
        let half = x >> 1;
        let equator = part(v.y, self.equator);
        let aside = part(v.y, self.aside);
        let up = part(v.z, self.elevation);
        [
            x,
            half + equator,
            equator - half,
            half + aside + up,
            aside + up - half,
            up - 2 * aside,
        ]
    }
}
