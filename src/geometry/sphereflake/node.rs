use fixed::types::I1F31;

use super::super::ray::Ray;
use super::child_frame::{axis, to_child};
use super::parameters::{NodePath, Radii, Sphereflake};
use crate::math::{
    Product, Square, Unit, Vec3, high, round_unit, rounded, square_root, upper_word, wide,
};

/// Converts from Q59 to Q29, rounded.
fn round_radii(bits: i64) -> Radii {
    Radii::from_bits(rounded::<30>(bits))
}

/// Returns the upper word of `x << shift`, for shifts of 1 to 31.
fn shifted_upper_word(x: i64, shift: u32) -> i32 {
    high(x) << (shift & 31) | (x as u32 >> (32_u32.wrapping_sub(shift) & 31)) as i32
}

/// A ray relative to one sphere of the flake. The coordinates are in the frame of the sphere. The
/// radius of the sphere is the unit of length.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// The foot, which is the point of the ray's line that is nearest to the center of the sphere.
    pub(super) foot: Vec3<Radii>,
    pub(super) direction: Vec3<Unit>,
    /// Distance from the ray's origin to the foot, in units of the scene, Q60.
    pub(super) distance: i64,
    /// Radius of the sphere in units of the scene.
    pub(super) radius: I1F31,
    /// Radius of the sphere that bounds this sphere and all its descendants. The unit is the radius
    /// of this sphere.
    pub(super) bound: Radii,
    pub(super) path: NodePath,
}

impl Node {
    /// Returns the node of the root sphere. `t_max` is the largest distance of interest, in Q60.
    /// Returns `None` if the ray meets the flake's bounding sphere only behind the origin or beyond
    /// `t_max`, or not at all.
    pub(super) fn root(flake: &Sphereflake, ray: &Ray, t_max: i64) -> Option<Self> {
        let d = ray.direction;
        let offset = ray.origin.coordinates - flake.center;
        // The product of Q28 and Q30 has Q58 and is rounded to Q28. This rounding moves the foot
        // along the ray. The error is corrected later, where the ray hits a sphere.
        let distance = -rounded::<30>(offset.along(d).to_bits());
        let radius = I1F31::from_bits((flake.radius.to_bits() >> 1) as i32);
        // The product of Q29 and Q31 has Q60; its upper word has Q28.
        let bound = upper_word(flake.bound.to_bits(), radius.to_bits()) + 1;
        if distance + bound <= 0 || distance - bound > high(t_max) {
            return None;
        }
        // The squares have Q56. An error of the direction changes the computed distance of the ray
        // from the center. The margin covers this change.
        let square = |c: i32| c.square();
        if offset.squared().to_bits() - square(distance) - square(bound) > 1 << 34 {
            return None;
        }
        // The foot has Q58 and is exact.
        let foot = offset.zip(d, |o, d| {
            (i64::from(o.to_bits()) << 30) + d.to_bits().product(distance)
        });
        // The margin of the previous test may be larger than a small flake. Therefore each
        // coordinate of the foot is also compared with the radius of the bounding sphere.
        let shift = flake.radius.leading_zeros();
        let most = i64::from(bound) << 30;
        if shift > 8 && !foot.all(|c| (-most..=most).contains(&c)) {
            return None;
        }
        // Converts the foot to the unit of the root sphere's radius. A shift by a power of two
        // turns Q58 into Q29. A product then applies the remaining factor, from 1 to 2. The shift
        // is rounded, because every generation magnifies its error.
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

    /// Returns the squared distance of the foot from the center, in square radii, Q58.
    pub(super) fn foot_squared(&self) -> i64 {
        let foot = self.foot;
        let square = foot.x.square() + foot.y.square() + foot.z.square();
        square.to_bits()
    }

    /// Returns three distances from the foot: to the entry of the ray's line into the sphere, to
    /// the middle of the chord, and to the exit. All three are equal if the line misses the sphere.
    ///
    /// Rounding moves the foot along the line, so the middle of the chord is not exactly at the
    /// foot.
    #[inline(never)]
    pub(super) fn chord(&self) -> [Radii; 3] {
        let rest = ((1_i64 << 58) - self.foot_squared()).max(0);
        let half = Radii::from_bits(square_root(rest as u64) as i32);
        let Vec3 { x, y, z } = self.foot.zip(self.direction, |l, d| l.product(d));
        // The dot product is shifted from Q59 to Q29.
        let middle = -Radii::from_bits(((x + y + z).to_bits() >> 30) as i32);
        [middle - half, middle, middle + half]
    }

    /// Returns true if a part of the sphere may be ahead of the ray's origin and before
    /// `t_max`.
    pub(super) fn is_within(&self, t_max: i64) -> bool {
        // The radius is rounded up from Q31 to Q28.
        let radius = (self.radius.to_bits() >> 3) + 1;
        let distance = high(self.distance);
        distance + radius >= 0 && distance - radius <= high(t_max)
    }

    /// Returns the distance from the ray's origin to the point that is `past_foot` beyond the
    /// foot, in units of the scene, Q60.
    pub(super) fn distance_to(&self, past_foot: Radii) -> i64 {
        self.distance + past_foot.product(self.radius).to_bits()
    }

    /// Returns the outward unit normal at the entry or the exit of the ray, in the frame of the
    /// sphere. `past_foot` is the distance from the foot to that point.
    #[inline(never)]
    pub(super) fn normal(&self, past_foot: Radii) -> Vec3<Unit> {
        // The foot is shifted from Q29 to Q59. The product of `past_foot` in Q29 and the direction
        // in Q30 has Q59, too. The sum is rounded to Q30.
        self.foot.zip(self.direction, |l, d| {
            round_unit::<29>((i64::from(l.to_bits()) << 30) + past_foot.product(d).to_bits())
        })
    }

    /// Returns the radius of the bounding sphere of a child's subtree, rounded up. The unit is the
    /// radius of this sphere.
    pub(super) fn child_bound(&self, flake: &Sphereflake) -> Radii {
        Radii::from_bits(self.bound.to_bits() - (flake.step.to_bits() >> 1))
    }

    /// Returns the node of a child. The function finds the point of the ray nearest to the child's
    /// center, converts it to the unit of the child's radius, and rotates it into the child's
    /// frame.
    #[inline(never)]
    pub(super) fn child(&self, flake: &Sphereflake, child: u32, path_shift: u32) -> Self {
        let direction = to_child(self.direction.map(Unit::to_bits), child).map(Unit::from_bits);
        // `farther` is the distance from this sphere's foot to the child's foot. The product of two
        // Q30 numbers has Q60 and is rounded down to Q29. This rounding only moves the child's foot
        // along the ray.
        let farther = flake.step.product(direction.z).to_bits();
        let farther = Radii::from_bits((farther >> 31) as i32);
        let distance = self.distance_to(farther);
        // The child's foot is `(l - step a + farther d) / ratio`. The vector `l` is the foot of
        // this node, `a` the axis of the child and `d` the direction. The products of Q29 and Q30
        // have Q59. The last shift converts them to Q29 and multiplies by `2^shift`, the part of
        // `1 / ratio` that `inverse_ratio` lacks.
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
            // The product of Q31 and Q32 has Q63 and is rounded to Q31.
            radius: I1F31::from_bits(
                ((wide(self.radius.to_bits() as u32, flake.ratio.to_bits()) + (1 << 31)) >> 32)
                    as i32,
            ),
            bound: Radii::from_bits(bound),
            path: self.path | child << path_shift,
        }
    }
}
