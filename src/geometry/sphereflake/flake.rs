use core::ops::Neg;

use fixed::types::{I3F29, U0F32, U1F15};

use crate::math::outlined::reciprocal;
use crate::math::{Length, Product, Unit, Vec3, round_unit};

use super::direction::{ASIDE, ELEVATION};
use crate::geometry::bounds::BoundingSphere;

/// A length in radii of a sphere: ±4 in steps of 2^-29.
pub(crate) type Radii = I3F29;

/// The most generations of smaller spheres.
pub(crate) const MAX_DEPTH: u8 = 8;

/// A sphere of the flake: for each generation, from the first, four bits that
/// tell the child, 1 to 12. The largest sphere is 0.
pub(crate) type NodePath = u32;

/// What a sphereflake is made of.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SphereflakeParams {
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

/// The directions u and v of a flake that is not turned.
const UPRIGHT: [Vec3<Unit>; 2] = [
    Vec3::new(Unit::ONE, Unit::ZERO, Unit::ZERO),
    Vec3::new(Unit::ZERO, Unit::ZERO, Unit::NEG_ONE),
];

/// A sphereflake.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sphereflake {
    pub(super) center: Vec3<Length>,
    /// The directions u, v and w of the largest sphere.
    pub(super) axes: Vec3<Vec3<Unit>>,
    pub(super) radius: U0F32,
    /// Whether u, v and w are x, -z and y.
    pub(super) is_upright: bool,
    /// `1 / (radius * 2^n)`, with n such that the quotient is 1 to 2.
    pub(super) inverse_radius: Unit,
    pub(super) ratio: U0F32,
    /// `1 / (ratio * 2^shift)`: 1 to 2.
    pub(super) inverse_ratio: Unit,
    pub(super) shift: u8,
    /// From a sphere's center to a child's, in radii: 1.1 to 1.5.
    pub(super) step: Unit,
    /// From a child's center to its parent's in radii of the child, divided by
    /// 2^shift: `-(1 / ratio + 1)`.
    pub(super) back: Radii,
    pub(super) steps: Steps,
    /// All of it is within so many radii.
    pub(super) bound: Radii,
    pub(super) depth: u8,
}

impl Sphereflake {
    #[inline(never)]
    pub(crate) fn new(parts: SphereflakeParams) -> Self {
        let SphereflakeParams {
            center,
            frame,
            radius,
            ratio,
            depth,
        } = parts;
        let [u, v] = frame;
        let w = u.cross(v).map(round_unit::<30>);
        let inverse_ratio = inverse(ratio);
        // Q30 -> Q29
        let one = (1_i32 << 29).unbounded_shr(ratio.leading_zeros());
        let back = (inverse_ratio.to_bits() >> 1) + one;
        let step = Unit::from_bits((1 << 30) + ((ratio.to_bits() >> 1).div_ceil(2)) as i32);
        Self {
            center,
            axes: Vec3::new(u, v, w),
            is_upright: frame == UPRIGHT,
            radius,
            inverse_radius: inverse(radius),
            ratio,
            inverse_ratio,
            shift: ratio.leading_zeros() as u8,
            back: Radii::from_bits(-back),
            step,
            steps: Steps::new(step),
            bound: Self::bound(ratio, depth),
            depth,
        }
    }

    /// What it was made of.
    pub(crate) fn parts(&self) -> SphereflakeParams {
        SphereflakeParams {
            center: self.center,
            frame: [self.axes.x, self.axes.y],
            radius: self.radius,
            ratio: self.ratio,
            depth: self.depth,
        }
    }

    /// A sphere around all of it.
    pub(crate) fn bounding_sphere(&self) -> BoundingSphere {
        // U0F32 * Q29 -> Q61 -> Q28, rounded up.
        let reach = self.radius.to_bits().product(self.bound.to_bits() as u32);
        BoundingSphere {
            center: self.center,
            radius: Length::from_bits((reach >> 33) as i32 + 1),
        }
    }

    /// How far a flake reaches, in radii, rounded up: a child's center is `1 +
    /// ratio` away, and its own children reach so far in its radii.
    #[inline(never)]
    pub(crate) fn bound(ratio: U0F32, depth: u8) -> Radii {
        let ratio = u64::from(ratio.to_bits());
        let bound = (0..depth).fold(1 << 28, |bound, _| bound_around(bound, ratio));
        Radii::from_bits((bound as i32 + 1) << 1)
    }

    /// [`Self::step`] in 16 bits.
    #[inline(always)]
    pub(super) fn coarse_step(&self) -> U1F15 {
        U1F15::from_bits(((self.step.to_bits() + (1 << 14)) >> 15) as u16)
    }

    /// A vector of the scene in the frame of the largest sphere.
    #[inline(always)]
    pub(super) fn inward<T: Copy + Neg<Output = T>>(
        &self,
        v: Vec3<T>,
        along: impl Fn(Vec3<T>, Vec3<Unit>) -> T,
    ) -> Vec3<T> {
        if self.is_upright {
            return Vec3::new(v.x, -v.z, v.y);
        }
        self.axes.map(|axis| along(v, axis))
    }

    /// A unit vector of that frame in the scene.
    #[inline(always)]
    pub(super) fn outward(&self, Vec3 { x, y, z }: Vec3<Unit>) -> Vec3<Unit> {
        if self.is_upright {
            return Vec3::new(x, z, -y);
        }
        let Vec3 { x: u, y: v, z: w } = self.axes;
        let along = |u, v, w| Vec3::new(x, y, z).cosine(Vec3::new(u, v, w));
        Vec3::new(
            along(u.x, v.x, w.x),
            along(u.y, v.y, w.y),
            along(u.z, v.z, w.z),
        )
    }
}

/// `1 / (x * 2^n)`, with n such that the quotient is 1 to 2.
#[inline(never)]
fn inverse(x: U0F32) -> Unit {
    let mantissa = x.to_bits().wrapping_shl(x.leading_zeros()) | 1 << 31;
    let half = reciprocal(mantissa).saturating_add(1) >> 1;
    Unit::from_bits(half.min(i32::MAX as u32) as i32)
}

/// The bound of a sphere whose children have that bound, U4F28. Not inlined, as the loop
/// over generations would be unrolled.
#[inline(never)]
fn bound_around(child: u64, ratio: u64) -> u64 {
    (1 << 28) + (ratio >> 4) + ((ratio * child) >> 32) + 2
}

/// The terms of directions to children, `1 + ratio` long, but for that length itself.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Steps {
    aside: U1F15,
    elevation: U1F15,
}

impl Steps {
    fn new(step: Unit) -> Self {
        // Q30 * Q30 -> Q60 -> Q15, rounded
        let part =
            |k: Unit| U1F15::from_bits(((step.product(k).to_bits() + (1 << 44)) >> 45) as u16);
        Self {
            aside: part(ASIDE),
            elevation: part(ELEVATION),
        }
    }

    /// The dot products of a vector of 16 bits with the first six directions,
    /// of which the others are the opposites: Q15, shifted right.
    #[inline(always)]
    pub(super) fn dots(&self, step: U1F15, v: Vec3<i32>, shift: u32) -> [i32; 6] {
        let part = |c: i32, k: U1F15| (c * i32::from(k.to_bits())) >> shift;
        let x = part(v.x, step);
        let half = x >> 1;
        let aside = part(v.y, self.aside);
        let equator = 3 * aside;
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
