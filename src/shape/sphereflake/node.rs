use fixed::types::I1F31;

use crate::Vec3;
use crate::num::{Product, Square, Unit, square_root, wide};
use crate::ray::Ray;
use crate::vector::round_unit;

use super::direction::{axis, inward};
use super::flake::{Path, Radii, Sphereflake};

/// A ray as a sphere of the flake sees it: in the sphere's frame and its radii.
#[derive(Clone, Copy, Debug)]
pub(super) struct Node {
    /// The point of the ray's line that is nearest to the center.
    pub(super) foot: Vec3<Radii>,
    pub(super) direction: Vec3<Unit>,
    /// From the ray's origin to the foot, Q56 of the scene.
    pub(super) distance: i64,
    pub(super) radius: I1F31,
    /// The sphere and all that follows from it is within so many radii.
    pub(super) bound: Radii,
}

/// The part of a ray's line within a sphere.
pub(super) struct Chord {
    pub(super) path: Path,
    /// Q56; below 0 behind the ray's origin.
    pub(super) entry: i64,
    pub(super) exit: i64,
    half: Radii,
    foot: Vec3<Radii>,
    direction: Vec3<Unit>,
}

impl Chord {
    /// The outward normal at an end, in the sphere's frame.
    pub(super) fn normal(&self, at_exit: bool) -> Vec3<Unit> {
        let half = if at_exit { self.half } else { -self.half };
        // Q29 -> Q59; Q29 * Q30 -> Q59; rounded to Q30.
        self.foot.zip(self.direction, |l, d| {
            round_unit(
                (i64::from(l.to_bits()) << 30) + half.product(d).to_bits(),
                29,
            )
        })
    }
}

/// A length in radii as Q56 of the scene: `Q29 * Q31 -> Q60 -> Q56`.
#[inline(always)]
pub(super) fn scaled(radii: Radii, radius: I1F31) -> i64 {
    radii.to_bits().product(radius.to_bits()) >> 4
}

impl Node {
    /// The largest sphere, if the ray's line passes within its bound.
    #[inline]
    pub(super) fn largest(flake: &Sphereflake, ray: &Ray) -> Option<Self> {
        let d = ray.direction;
        let offset = ray.origin.coordinates - flake.center;
        // What is rounded away moves the foot along the ray, where it does no
        // harm: Q28 * Q30 -> Q58 -> Q28.
        let distance = -((offset.along(d).to_bits() + (1 << 29)) >> 30);
        // Q58, exact.
        let foot = offset.zip(d, |o, d| {
            (i64::from(o.to_bits()) << 30) + i64::from(d.to_bits()) * distance
        });
        let radius = I1F31::from_bits((flake.radius.to_bits() >> 1) as i32);
        let most = (scaled(flake.bound, radius) << 2) + (1 << 30);
        if !foot.all(|c| (-most..=most).contains(&c)) {
            return None;
        }
        // In radii: by the power of two, Q58 -> Q29, then by what is left, 1 to 2.
        let shift = flake.radius.leading_zeros();
        let foot = foot.map(|c| {
            let product = ((c << shift) >> 29) * i64::from(flake.inverse_radius);
            Radii::from_bits(((product + (1 << 30)) >> 31) as i32)
        });
        let node = Self {
            foot,
            direction: d,
            distance: distance << 28,
            radius,
            bound: flake.bound,
        };
        if node.squared() > node.bound.square().to_bits() as u64 >> 2 {
            return None;
        }
        let [u, v, w] = flake.axes();
        let turned = |axis: Vec3<Unit>| {
            let sum = foot.x.product(axis.x) + foot.y.product(axis.y) + foot.z.product(axis.z);
            Radii::from_bits(((sum.to_bits() + (1 << 29)) >> 30) as i32)
        };
        Some(Self {
            foot: Vec3::new(turned(u), turned(v), turned(w)),
            direction: Vec3::new(d.cosine(u), d.cosine(v), d.cosine(w)),
            ..node
        })
    }

    /// The square of the foot's distance, Q56 of square radii.
    #[inline(always)]
    pub(super) fn squared(&self) -> u64 {
        let square = self.foot.map(|c| c.square().to_bits() as u64 >> 2);
        square.x + square.y + square.z
    }

    /// Whether some of all that is within the bound may be ahead and within reach.
    #[inline]
    pub(super) fn is_within(&self, reach: i64) -> bool {
        let bound = scaled(self.bound, self.radius);
        self.distance + bound > 0 && self.distance - bound < reach
    }

    /// What the sphere itself cuts out of the ray's line.
    #[inline]
    pub(super) fn chord(&self, path: Path) -> Option<Chord> {
        let rest = (1_u64 << 56).checked_sub(self.squared())?;
        Some(self.chord_of(path, rest))
    }

    /// The same; where the line passes by, the foot alone.
    pub(super) fn chord_or_foot(&self, path: Path) -> Chord {
        self.chord_of(path, (1_u64 << 56).saturating_sub(self.squared()))
    }

    #[inline(always)]
    fn chord_of(&self, path: Path, rest: u64) -> Chord {
        // Q58 -> Q29
        let half = Radii::from_bits(square_root(rest << 2) as i32);
        let length = scaled(half, self.radius);
        Chord {
            path,
            entry: self.distance - length,
            exit: self.distance + length,
            half,
            foot: self.foot,
            direction: self.direction,
        }
    }

    /// From the ray's origin to a child's foot, which is so many radii (Q30)
    /// farther: `Q30 * Q31 -> Q61 -> Q56`.
    #[inline(always)]
    pub(super) fn foot_of(&self, farther: i32) -> i64 {
        self.distance + (farther.product(self.radius.to_bits()) >> 5)
    }

    /// How far from a child's center all that follows from it reaches, in the
    /// radii of the parent, rounded up.
    #[inline(always)]
    pub(super) fn child_bound(&self, flake: &Sphereflake) -> Radii {
        Radii::from_bits(self.bound.to_bits() - (flake.steps.along.to_bits() >> 1) + 1)
    }

    /// The same ray as a child sees it: the foot is taken anew, turned and
    /// brought to the child's radii.
    #[inline]
    pub(super) fn child(&self, flake: &Sphereflake, child: u32) -> Self {
        let axis = axis(child);
        let step = flake.steps.along;
        // How much farther the child's foot is: Q30 * Q30 -> Q30
        let farther = round_unit(step.product(self.direction.cosine(axis)).to_bits(), 30);
        // l - step a + farther d: Q29 -> Q60; Q30 * Q30 -> Q60; rounded to Q30.
        let foot = self.foot.map(|l| i64::from(l.to_bits()) << 31);
        let foot = foot.zip(axis, |l, a| l - step.product(a).to_bits());
        let foot = foot.zip(self.direction, |l, d| {
            round_unit(l + farther.product(d).to_bits(), 30)
        });
        let inverse = i64::from(flake.inverse_ratio.to_bits());
        Self {
            // Q30 * Q28 -> Q58 -> Q29
            foot: inward(foot, child).map(|c| {
                Radii::from_bits(((i64::from(c.to_bits()) * inverse + (1 << 28)) >> 29) as i32)
            }),
            direction: inward(self.direction, child),
            distance: self.foot_of(farther.to_bits()),
            radius: I1F31::from_bits(
                ((wide(self.radius.to_bits() as u32, flake.ratio.to_bits()) + (1 << 31)) >> 32)
                    as i32,
            ),
            // Rounded up.
            bound: Radii::from_bits(
                ((i64::from(self.child_bound(flake).to_bits()) * inverse) >> 28) as i32 + 1,
            ),
        }
    }
}
