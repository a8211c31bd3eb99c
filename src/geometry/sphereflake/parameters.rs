use core::ops::Neg;

use fixed::types::{I3F29, U0F32, U1F15};

use super::super::valid;
use super::child_frame::{ELEVATION, HALF_COSINE};
use crate::math::{Length, Product, Unit, Vec3, reciprocal_outlined, round_unit, wide};

/// A length in radii of a sphere: ±4 in steps of 2^-29.
pub(super) type Radii = I3F29;

/// Largest number of generations of smaller spheres.
pub(crate) const MAX_DEPTH: u8 = 8;

/// A sphere of the flake: four bits per generation, from the first one, for the child, 1 to
/// 12. The root sphere is 0.
pub(super) type NodePath = u32;

/// The independent parameters of a sphereflake.
#[derive(Clone, Copy, Debug)]
pub(super) struct SphereflakeParams {
    pub(super) center: Vec3<Length>,
    /// Axes u and v of the root sphere; w is their cross product.
    pub(super) frame: [Vec3<Unit>; 2],
    /// Radius of the root sphere, such that the whole flake is within ±1.
    pub(super) radius: U0F32,
    /// Radius of a sphere divided by that of its parent: 0.1 to 0.5.
    pub(super) ratio: U0F32,
    /// Number of generations, at most [`MAX_DEPTH`].
    pub(super) depth: u8,
}

impl SphereflakeParams {
    /// Returns true if every parameter is in the range that tracing relies on.
    #[inline(never)]
    pub(super) fn is_valid(&self) -> bool {
        let [u, v] = &self.frame;
        valid::is_within_one(&self.center)
            && valid::is_unit(u)
            && valid::is_unit(v)
            && valid::are_orthogonal(u, v)
            && self.depth <= MAX_DEPTH
            && (const { U0F32::lit("0.099") }..=const { U0F32::lit("0.5") }).contains(&self.ratio)
            && self.radius > 0
            && self.reach() <= 1 << 61
    }

    /// Radius of the bounding sphere, Q61.
    fn reach(&self) -> u64 {
        let bound = bounding_radius(self.ratio, self.depth);
        wide(self.radius.to_bits(), bound.to_bits() as u32)
    }
}

/// Axes u and v of a flake without rotation.
const UPRIGHT: [Vec3<Unit>; 2] = [
    Vec3::new(Unit::ONE, Unit::ZERO, Unit::ZERO),
    Vec3::new(Unit::ZERO, Unit::ZERO, Unit::NEG_ONE),
];

/// A sphereflake: its parameters and the constants derived from them.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sphereflake {
    pub(super) center: Vec3<Length>,
    /// Axes u, v and w of the root sphere.
    axes: Vec3<Vec3<Unit>>,
    pub(super) radius: U0F32,
    /// True if u, v and w are x, -z and y.
    is_upright: bool,
    /// `1 / (radius * 2^n)`, with n such that the quotient is 1 to 2.
    pub(super) inverse_radius: Unit,
    pub(super) ratio: U0F32,
    /// `1 / (ratio * 2^shift)`: 1 to 2.
    pub(super) inverse_ratio: Unit,
    pub(super) shift: u8,
    /// Distance from a sphere's center to its child's, in radii: 1.1 to 1.5.
    pub(super) step: Unit,
    /// Distance from a child's center to its parent's, in radii of the child, negative and
    /// divided by 2^shift: `-(1 / ratio + 1)`.
    pub(super) back: Radii,
    pub(super) steps: Steps,
    /// Radius of the bounding sphere, in radii of the root sphere.
    pub(super) bound: Radii,
    pub(super) depth: u8,
}

impl Sphereflake {
    #[inline(never)]
    pub(super) fn new(params: SphereflakeParams) -> Self {
        let SphereflakeParams {
            center,
            frame,
            radius,
            ratio,
            depth,
        } = params;
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
            bound: bounding_radius(ratio, depth),
            depth,
        }
    }

    /// Returns the independent parameters.
    pub(super) fn params(&self) -> SphereflakeParams {
        SphereflakeParams {
            center: self.center,
            frame: [self.axes.x, self.axes.y],
            radius: self.radius,
            ratio: self.ratio,
            depth: self.depth,
        }
    }

    /// Radius of the bounding sphere, rounded up.
    pub(super) fn reach(&self) -> Length {
        // U0F32 * Q29 -> Q61 -> Q28
        let reach = self.radius.to_bits().product(self.bound.to_bits() as u32);
        Length::from_bits((reach >> 33) as i32 + 1)
    }

    /// [`Self::step`] in 16 bits.
    #[inline(always)]
    pub(super) fn step_u16(&self) -> U1F15 {
        U1F15::from_bits(((self.step.to_bits() + (1 << 14)) >> 15) as u16)
    }

    /// Converts a vector of the scene to the frame of the root sphere; `along` computes a
    /// dot product with an axis.
    #[inline(always)]
    pub(super) fn world_to_local<T: Copy + Neg<Output = T>>(
        &self,
        v: Vec3<T>,
        along: impl Fn(Vec3<T>, Vec3<Unit>) -> T,
    ) -> Vec3<T> {
        if self.is_upright {
            return Vec3::new(v.x, -v.z, v.y);
        }
        self.axes.map(|axis| along(v, axis))
    }

    /// Converts a unit vector of the root sphere's frame to the scene.
    #[inline(always)]
    pub(super) fn local_to_world(&self, Vec3 { x, y, z }: Vec3<Unit>) -> Vec3<Unit> {
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

/// Radius of the bounding sphere of a flake, in radii, rounded up: the center of a child is
/// `1 + ratio` away, and the children's own subtrees reach as far in their radii.
#[inline(never)]
pub(super) fn bounding_radius(ratio: U0F32, depth: u8) -> Radii {
    let ratio = u64::from(ratio.to_bits());
    let bound = (0..depth).fold(1 << 28, |bound, _| parent_bound(bound, ratio));
    Radii::from_bits((bound as i32 + 1) << 1)
}

/// Bound of a sphere from that of its children, U4F28. Out of line, or the loop over the
/// generations is unrolled.
#[inline(never)]
fn parent_bound(child: u64, ratio: u64) -> u64 {
    (1 << 28) + (ratio >> 4) + ((ratio * child) >> 32) + 2
}

/// `1 / (x * 2^n)`, with n such that the quotient is 1 to 2.
#[inline(never)]
fn inverse(x: U0F32) -> Unit {
    let mantissa = x.to_bits().wrapping_shl(x.leading_zeros()) | 1 << 31;
    let half = reciprocal_outlined(mantissa).saturating_add(1) >> 1;
    Unit::from_bits(half.min(i32::MAX as u32) as i32)
}

/// The components of the vectors from a sphere to its children, which are `1 + ratio` long,
/// in 16 bits. The length itself is kept apart.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Steps {
    half_cosine: U1F15,
    elevation: U1F15,
}

impl Steps {
    fn new(step: Unit) -> Self {
        // Q30 * Q30 -> Q60 -> Q15, rounded
        let part =
            |k: Unit| U1F15::from_bits(((step.product(k).to_bits() + (1 << 44)) >> 45) as u16);
        Self {
            half_cosine: part(HALF_COSINE),
            elevation: part(ELEVATION),
        }
    }

    /// Dot products of a 16-bit vector with the vectors to the first six children, Q15,
    /// shifted right. The other six are their opposites.
    #[inline(always)]
    pub(super) fn dots(&self, step: U1F15, v: Vec3<i32>, shift: u32) -> [i32; 6] {
        let part = |c: i32, k: U1F15| (c * i32::from(k.to_bits())) >> shift;
        let x = part(v.x, step);
        let half = x >> 1;
        let aside = part(v.y, self.half_cosine);
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
