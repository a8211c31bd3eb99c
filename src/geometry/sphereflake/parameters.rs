use core::ops::Neg;

use fixed::types::{I3F29, U0F32, U1F15};

use super::super::valid;
use super::child_frame::{ELEVATION, HALF_COSINE};
use crate::math::{Length, Product, Unit, Vec3, reciprocal_outlined, round_unit, wide};

/// A length in radii of a sphere, within ±4 and in units of 2^-29.
pub(super) type Radii = I3F29;

/// Largest number of generations of spheres below the root sphere.
pub(crate) const MAX_DEPTH: u8 = 8;

/// The path from the root sphere to a sphere of the flake. A path has four bits for each
/// generation, which hold the number of the child, 1 to 12. The lowest four bits are for the first
/// generation. The root sphere has the path 0.
pub(super) type NodePath = u32;

/// The independent parameters of a sphereflake.
#[derive(Clone, Copy, Debug)]
pub(super) struct SphereflakeParams {
    pub(super) center: Vec3<Length>,
    /// Axes u and v of the root sphere; w is their cross product.
    pub(super) frame: [Vec3<Unit>; 2],
    /// Radius of the root sphere. The radius is so small that all coordinates of the flake are
    /// within ±1.
    pub(super) radius: U0F32,
    /// Radius of a sphere divided by that of its parent: 0.1 to 0.5.
    pub(super) ratio: U0F32,
    /// Number of generations below the root sphere, at most [`MAX_DEPTH`].
    pub(super) depth: u8,
}

impl SphereflakeParams {
    /// Returns true if every parameter is in the range for which tracing is correct.
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

    /// Returns the radius of the flake's bounding sphere, Q61.
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
    /// True if the axes u, v and w are x, -z and y.
    is_upright: bool,
    /// Scaled reciprocal of the radius, `1 / (radius * 2^n)`. The integer n is such that the
    /// value is between 1 and 2.
    pub(super) inverse_radius: Unit,
    pub(super) ratio: U0F32,
    /// Scaled reciprocal of the ratio, `1 / (ratio * 2^shift)`, between 1 and 2.
    pub(super) inverse_ratio: Unit,
    pub(super) shift: u8,
    /// Distance from the center of a sphere to the center of its child, in radii of the sphere:
    /// 1.1 to 1.5.
    pub(super) step: Unit,
    /// Scaled distance from the center of a child to the center of its parent, as a negative
    /// number. In radii of the child, the distance is `1 / ratio + 1`. The scale divides it by
    /// `2^shift`.
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
        // The reciprocal is shifted from Q30 to Q29. In Q29, `one` is 2^-shift.
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

    /// Returns the radius of the flake's bounding sphere, rounded up.
    pub(super) fn reach(&self) -> Length {
        // The product of `U0F32` and Q29 has Q61 and is shifted to Q28.
        let reach = self.radius.to_bits().product(self.bound.to_bits() as u32);
        Length::from_bits((reach >> 33) as i32 + 1)
    }

    /// Returns [`Self::step`] rounded to 16 bits.
    pub(super) fn step_u16(&self) -> U1F15 {
        U1F15::from_bits(((self.step.to_bits() + (1 << 14)) >> 15) as u16)
    }

    /// Converts a vector from the frame of the scene to the frame of the root sphere. The argument
    /// `along` is a function that returns the dot product of a vector with an axis.
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

    /// Converts a unit vector from the frame of the root sphere to the frame of the scene.
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

/// Returns the radius of the bounding sphere of a flake, rounded up. The unit is the radius of the
/// root sphere. The function starts with a flake of one sphere and adds one generation at a time.
#[inline(never)]
pub(super) fn bounding_radius(ratio: U0F32, depth: u8) -> Radii {
    let ratio = u64::from(ratio.to_bits());
    let bound = (0..depth).fold(1 << 28, |bound, _| parent_bound(bound, ratio));
    Radii::from_bits((bound as i32 + 1) << 1)
}

/// Returns the bounding radius of a sphere with its descendants, in radii of that sphere. The
/// argument `child` is the bounding radius of a child with its descendants, in radii of the child.
/// Both numbers have the format U4F28.
///
/// The center of the child is `1 + ratio` away, so the result is `1 + ratio + ratio * child`. The
/// function is not inlined, because the compiler would then unroll the loop over the generations.
#[inline(never)]
fn parent_bound(child: u64, ratio: u64) -> u64 {
    (1 << 28) + (ratio >> 4) + ((ratio * child) >> 32) + 2
}

/// Returns the scaled reciprocal `1 / (x * 2^n)`. The integer n is such that the result is
/// between 1 and 2.
#[inline(never)]
fn inverse(x: U0F32) -> Unit {
    let mantissa = x.to_bits().wrapping_shl(x.leading_zeros()) | 1 << 31;
    let half = reciprocal_outlined(mantissa).saturating_add(1) >> 1;
    Unit::from_bits(half.min(i32::MAX as u32) as i32)
}

/// Components of the vectors from the center of a sphere to the centers of its children. Each
/// component has 16 bits. The length of these vectors, `1 + ratio`, is a field of [`Sphereflake`].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Steps {
    half_cosine: U1F15,
    elevation: U1F15,
}

impl Steps {
    fn new(step: Unit) -> Self {
        // The product of two Q30 numbers has Q60 and is rounded to Q15.
        let part =
            |k: Unit| U1F15::from_bits(((step.product(k).to_bits() + (1 << 44)) >> 45) as u16);
        Self {
            half_cosine: part(HALF_COSINE),
            elevation: part(ELEVATION),
        }
    }

    /// Returns the dot products of `v` with the vectors to the first six children. The components
    /// of `v` have 16 bits, and those of the vectors to the children have Q15. Each product is
    /// shifted right by `shift`. The dot products for the other six children are the negatives of
    /// the results.
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
