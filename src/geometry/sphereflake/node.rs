use fixed::types::I1F31;

use super::super::ray::Ray;
use super::child_frame::{axis, to_child};
use super::parameters::{NodePath, Radii, Sphereflake};
use crate::math::{
    Product, Square, Unit, Vec3, high, round_unit, rounded, square_root, upper_word, wide,
};

/// Q59 -> Q29
#[inline(always)]
fn round_radii(bits: i64) -> Radii {
    Radii::from_bits(rounded::<30>(bits))
}

/// The upper word of `x << shift`, for shifts of 1 to 31.
#[inline(always)]
fn shifted_upper_word(x: i64, shift: u32) -> i32 {
    high(x) << (shift & 31) | (x as u32 >> (32_u32.wrapping_sub(shift) & 31)) as i32
}

/// A ray in the frame and the radii of one sphere of the flake.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// Point of the ray's line that is nearest to the center of the sphere.
    pub(super) foot: Vec3<Radii>,
    pub(super) direction: Vec3<Unit>,
    /// Distance from the ray's origin to the foot, Q60 of the scene.
    pub(super) distance: i64,
    /// Radius of the sphere in the scene.
    pub(super) radius: I1F31,
    /// Radius of the bounding sphere of the subtree, in radii.
    pub(super) bound: Radii,
    pub(super) path: NodePath,
}

impl Node {
    /// Returns the node of the root sphere, if the ray passes through its bounding sphere
    /// ahead of the origin and before the distance `t_max`, Q60.
    pub(super) fn root(flake: &Sphereflake, ray: &Ray, t_max: i64) -> Option<Self> {
        let d = ray.direction;
        let offset = ray.origin.coordinates - flake.center;
        // The rounding of the distance moves the foot along the ray, and is corrected where a
        // sphere is hit: Q28 * Q30 -> Q58 -> Q28.
        let distance = -rounded::<30>(offset.along(d).to_bits());
        let radius = I1F31::from_bits((flake.radius.to_bits() >> 1) as i32);
        // Q29 * Q31 -> Q60 -> Q28
        let bound = upper_word(flake.bound.to_bits(), radius.to_bits()) + 1;
        if distance + bound <= 0 || distance - bound > high(t_max) {
            return None;
        }
        // Q56. The margin is what the error of the direction can change of a distance.
        let square = |c: i32| c.square();
        if offset.squared().to_bits() - square(distance) - square(bound) > 1 << 34 {
            return None;
        }
        // Q58, exact.
        let foot = offset.zip(d, |o, d| {
            (i64::from(o.to_bits()) << 30) + d.to_bits().product(distance)
        });
        // For a small flake that margin may be larger than the flake.
        let shift = flake.radius.leading_zeros();
        let most = i64::from(bound) << 30;
        if shift > 8 && !foot.all(|c| (-most..=most).contains(&c)) {
            return None;
        }
        // To radii: first by the power of two, Q58 -> Q29, then by the remaining factor of 1
        // to 2. Every generation magnifies the rounding here.
        let half = i64::from(1_u32 << (28_u32.wrapping_sub(shift) & 31));
        let foot = foot.map(|c| {
            let c = shifted_upper_word(c + half, shift + 3);
            round_radii(c.product(flake.inverse_radius.to_bits()))
        });
        let node = Self {
            foot: flake.world_to_local(foot, |v, axis| {
                let Vec3 { x, y, z } = v.zip(axis, Radii::product);
                round_radii((x + y + z).to_bits())
            }),
            direction: flake.world_to_local(d, Vec3::cosine),
            distance: i64::from(distance) << 32,
            radius,
            bound: flake.bound,
            path: 0,
        };
        (node.foot_squared() <= node.bound.square().to_bits()).then_some(node)
    }

    /// Squared distance of the foot from the center, Q58 of square radii.
    #[inline(always)]
    pub(super) fn foot_squared(&self) -> i64 {
        let foot = self.foot;
        let square = foot.x.square() + foot.y.square() + foot.z.square();
        square.to_bits()
    }

    /// Distances from the foot to the entry, the middle and the exit of the chord that the
    /// sphere cuts out of the line. All three are equal if the line misses the sphere.
    ///
    /// The middle is not zero, because roundings move the foot along the line.
    #[inline(never)]
    pub(super) fn chord(&self) -> [Radii; 3] {
        let rest = ((1_i64 << 58) - self.foot_squared()).max(0);
        let half = Radii::from_bits(square_root(rest as u64) as i32);
        let Vec3 { x, y, z } = self.foot.zip(self.direction, |l, d| l.product(d));
        // Q59 -> Q29
        let middle = -Radii::from_bits(((x + y + z).to_bits() >> 30) as i32);
        [middle - half, middle, middle + half]
    }

    /// Returns true if a part of the sphere may be ahead of the origin and before `t_max`.
    #[inline(always)]
    pub(super) fn is_within(&self, t_max: i64) -> bool {
        // Q31 -> Q28, rounded up
        let radius = (self.radius.to_bits() >> 3) + 1;
        let distance = high(self.distance);
        distance + radius >= 0 && distance - radius <= high(t_max)
    }

    /// Distance from the ray's origin to a point past the foot, Q60 of the scene.
    #[inline(always)]
    pub(super) fn distance_to(&self, past_foot: Radii) -> i64 {
        self.distance + past_foot.product(self.radius).to_bits()
    }

    /// Outward unit normal at an end of the chord, in the frame of the sphere.
    #[inline(never)]
    pub(super) fn normal(&self, past_foot: Radii) -> Vec3<Unit> {
        // Q29 -> Q59; Q29 * Q30 -> Q59; rounded to Q30.
        self.foot.zip(self.direction, |l, d| {
            round_unit::<29>((i64::from(l.to_bits()) << 30) + past_foot.product(d).to_bits())
        })
    }

    /// Radius of the bounding sphere of a child's subtree, in the radii of this sphere,
    /// rounded up.
    #[inline(always)]
    pub(super) fn child_bound(&self, flake: &Sphereflake) -> Radii {
        Radii::from_bits(self.bound.to_bits() - (flake.step.to_bits() >> 1))
    }

    /// Returns the node of a child: finds the foot nearest to the child's center, scales it
    /// to the child's radii, and rotates it into the child's frame.
    #[inline(never)]
    pub(super) fn child(&self, flake: &Sphereflake, child: u32, path_shift: u32) -> Self {
        let direction = to_child(self.direction.map(Unit::to_bits), child).map(Unit::from_bits);
        // Distance from this foot to the child's: Q30 * Q30 -> Q60 -> Q29, rounded down, which
        // only moves the foot along the ray.
        let farther = flake.step.product(direction.z).to_bits();
        let farther = Radii::from_bits((farther >> 31) as i32);
        let distance = self.distance_to(farther);
        // (l - step a + farther d) / ratio: Q29 * Q30 -> Q59, and by the power of two -> Q29
        let inverse = flake.inverse_ratio;
        let scaled_farther = Radii::from_bits((farther.product(inverse).to_bits() >> 30) as i32);
        let shift = u32::from(flake.shift);
        let foot = self.foot.map(|l| l.product(inverse));
        let foot = foot.zip(axis(child), |l, a| l + flake.back.product(a));
        let foot = foot.zip(self.direction, |l, d| {
            shifted_upper_word((l + scaled_farther.product(d)).to_bits(), shift + 2)
        });
        let bound =
            (upper_word(self.child_bound(flake).to_bits(), inverse.to_bits()) + 1) << (shift + 2);
        Self {
            foot: to_child(foot, child).map(Radii::from_bits),
            direction,
            distance,
            // Q31 * Q32 -> Q63 -> Q31
            radius: I1F31::from_bits(
                ((wide(self.radius.to_bits() as u32, flake.ratio.to_bits()) + (1 << 31)) >> 32)
                    as i32,
            ),
            bound: Radii::from_bits(bound),
            path: self.path | child << path_shift,
        }
    }
}
