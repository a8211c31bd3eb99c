use fixed::types::I1F31;

use crate::geometry::Ray;
use crate::math::{Product, Square, Unit, Vec3, high, round_unit, rounded, square_root, wide};

use super::direction::{axis, inward};
use super::flake::{NodePath, Radii, Sphereflake};
use super::word::{upper_product, upper_shifted};

/// Q59 -> Q29
#[inline(always)]
fn round_radii(bits: i64) -> Radii {
    Radii::from_bits(rounded::<30>(bits))
}

/// A ray as a sphere of the flake sees it: in the sphere's frame and its radii.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// The point of the ray's line that is nearest to the center.
    pub(super) foot: Vec3<Radii>,
    pub(super) direction: Vec3<Unit>,
    /// From the ray's origin to the foot, Q60 of the scene.
    pub(super) distance: i64,
    pub(super) radius: I1F31,
    /// The sphere and all that follows from it is within so many radii.
    pub(super) bound: Radii,
    pub(super) path: NodePath,
}

impl Node {
    /// The largest sphere, if the ray passes within its bound ahead, and up to
    /// `reach`.
    #[inline]
    pub(super) fn largest(flake: &Sphereflake, ray: &Ray, reach: i64) -> Option<Self> {
        let d = ray.direction;
        let offset = ray.origin.coordinates - flake.center;
        // What is rounded away moves the foot along the ray, and is made good
        // where a sphere is met: Q28 * Q30 -> Q58 -> Q28.
        let distance = -rounded::<30>(offset.along(d).to_bits());
        let radius = I1F31::from_bits((flake.radius.to_bits() >> 1) as i32);
        // Q29 * Q31 -> Q60 -> Q28
        let bound = upper_product(flake.bound.to_bits(), radius.to_bits()) + 1;
        if distance + bound <= 0 || distance - bound > high(reach) {
            return None;
        }
        // Q56; the margin is what the direction's error can do to a distance.
        let square = |c: i32| c.square();
        if offset.squared().to_bits() - square(distance) - square(bound) > 1 << 34 {
            return None;
        }
        // Q58, exact.
        let foot = offset.zip(d, |o, d| {
            (i64::from(o.to_bits()) << 30) + d.to_bits().product(distance)
        });
        // Of a small flake that margin may be large.
        let shift = flake.radius.leading_zeros();
        let most = i64::from(bound) << 30;
        if shift > 8 && !foot.all(|c| (-most..=most).contains(&c)) {
            return None;
        }
        // In radii: by the power of two, Q58 -> Q29, then by what is left, 1 to 2.
        // Each generation magnifies what is rounded here.
        let half = i64::from(1_u32 << (28_u32.wrapping_sub(shift) & 31));
        let foot = foot.map(|c| {
            let c = upper_shifted(c + half, shift + 3);
            round_radii(c.product(flake.inverse_radius.to_bits()))
        });
        let node = Self {
            foot: flake.inward(foot, |v, axis| {
                let Vec3 { x, y, z } = v.zip(axis, Radii::product);
                round_radii((x + y + z).to_bits())
            }),
            direction: flake.inward(d, Vec3::cosine),
            distance: i64::from(distance) << 32,
            radius,
            bound: flake.bound,
            path: 0,
        };
        (node.squared() <= node.bound.square().to_bits()).then_some(node)
    }

    /// The square of the foot's distance, Q58 of square radii.
    #[inline(always)]
    pub(super) fn squared(&self) -> i64 {
        let foot = self.foot;
        let square = foot.x.square() + foot.y.square() + foot.z.square();
        square.to_bits()
    }

    /// From the foot to the ends of what the sphere cuts out of the ray's line,
    /// and in between to its middle; all of that is one where the line passes by.
    ///
    /// The foot is off along the ray by what was rounded on the way here.
    #[inline(never)]
    pub(super) fn chord(&self) -> [Radii; 3] {
        let rest = ((1_i64 << 58) - self.squared()).max(0);
        let half = Radii::from_bits(square_root(rest as u64) as i32);
        let Vec3 { x, y, z } = self.foot.zip(self.direction, |l, d| l.product(d));
        // Q59 -> Q29
        let middle = -Radii::from_bits(((x + y + z).to_bits() >> 30) as i32);
        [middle - half, middle, middle + half]
    }

    /// Whether some of the sphere may be ahead and within reach.
    #[inline(always)]
    pub(super) fn is_within(&self, reach: i64) -> bool {
        // Q31 -> Q28, rounded up
        let radius = (self.radius.to_bits() >> 3) + 1;
        let distance = high(self.distance);
        distance + radius >= 0 && distance - radius <= high(reach)
    }

    /// From the ray's origin to so many radii past the foot, Q60 of the scene.
    #[inline(always)]
    pub(super) fn distance_to(&self, past_foot: Radii) -> i64 {
        self.distance + past_foot.product(self.radius).to_bits()
    }

    /// The outward normal at an end of the chord, in the sphere's frame.
    #[inline(never)]
    pub(super) fn normal(&self, past_foot: Radii) -> Vec3<Unit> {
        // Q29 -> Q59; Q29 * Q30 -> Q59; rounded to Q30.
        self.foot.zip(self.direction, |l, d| {
            round_unit::<29>((i64::from(l.to_bits()) << 30) + past_foot.product(d).to_bits())
        })
    }

    /// How far from a child's center all that follows from it reaches, in the
    /// radii of the parent, rounded up.
    #[inline(always)]
    pub(super) fn child_bound(&self, flake: &Sphereflake) -> Radii {
        Radii::from_bits(self.bound.to_bits() - (flake.step.to_bits() >> 1))
    }

    /// The same ray as a child sees it: the foot is taken anew, brought to the
    /// child's radii and turned.
    #[inline(never)]
    pub(super) fn child(&self, flake: &Sphereflake, child: u32, path_shift: u32) -> Self {
        let direction = inward(self.direction.map(Unit::to_bits), child).map(Unit::from_bits);
        // How much farther the child's foot is: Q30 * Q30 -> Q60 -> Q29, rounded
        // down, as that moves it along the ray only.
        let farther = flake.step.product(direction.z).to_bits();
        let farther = Radii::from_bits((farther >> 31) as i32);
        let distance = self.distance_to(farther);
        // (l - step a + farther d) / ratio: Q29 * Q30 -> Q59, and by the power
        // of two -> Q29
        let inverse = flake.inverse_ratio;
        let on = Radii::from_bits((farther.product(inverse).to_bits() >> 30) as i32);
        let shift = u32::from(flake.shift);
        let foot = self.foot.map(|l| l.product(inverse));
        let foot = foot.zip(axis(child), |l, a| l + flake.back.product(a));
        let foot = foot.zip(self.direction, |l, d| {
            upper_shifted((l + on.product(d)).to_bits(), shift + 2)
        });
        let bound = (upper_product(self.child_bound(flake).to_bits(), inverse.to_bits()) + 1)
            << (shift + 2);
        Self {
            foot: inward(foot, child).map(Radii::from_bits),
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
