//! The sphereflake: every sphere is touched by twelve smaller ones (Haines 1987).
//!
//! Nothing of it is stored. A ray walks the tree of spheres from the largest,
//! the nearer child first, and passes over what it misses as a whole. Each
//! level has a frame and a unit of its own, so that the smallest sphere is as
//! exact as the largest, and memory grows with the depth alone.

mod direction;
mod flake;
mod node;
mod walk;

pub(crate) use flake::{MAX_DEPTH, Parts, Path, Sphereflake};

use crate::Vec3;
use crate::num::{Length, Product, Unit};
use crate::observer::Observer;
use crate::ray::{Ray, Start};
use crate::vector::round_unit;
use node::{Chord, Node};
use walk::{Children, Levels, Walk};

/// Where a ray meets the flake first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Meeting {
    /// Q56.
    distance: i64,
    pub(crate) path: Path,
    /// Outward, in the frame of the sphere.
    normal: Vec3<Unit>,
}

impl Meeting {
    /// Rounded, and above 0.
    pub(crate) fn distance(&self) -> Length {
        Length::from_bits(((self.distance + (1 << 27)) >> 28).max(1) as i32)
    }
}

impl Sphereflake {
    /// The nearest hit ahead, if it is below `limit`, of a ray that starts
    /// `from` one of the spheres or elsewhere.
    pub(crate) fn nearest(
        &self,
        ray: &Ray,
        from: Option<Start>,
        limit: Length,
        observer: &mut impl Observer,
    ) -> Option<Meeting> {
        let mut reach = i64::from(limit.to_bits()) << 28;
        let mut nearest = None;
        if let Some(from) = from.filter(|from| from.inward) {
            let across = self.across(ray, from.part).filter(|it| it.distance < reach);
            reach = across.map_or(reach, |it| it.distance);
            nearest = across;
        }
        self.walk(ray, reach, observer, &mut |chord| {
            let ends = [chord.entry, chord.exit];
            let distance = ends.into_iter().find(|distance| *distance > 0);
            if let Some(distance) = distance
                && distance < reach
                && from.is_none_or(|from| from.part != chord.path)
            {
                reach = distance;
                nearest = Some(Meeting {
                    distance,
                    path: chord.path,
                    normal: chord.normal(distance == chord.exit),
                });
            }
            reach
        });
        nearest
    }

    /// From a point on a sphere through its inside to the other end of the
    /// chord, which is a point where the ray grazes the sphere.
    #[cold]
    fn across(&self, ray: &Ray, path: Path) -> Option<Meeting> {
        let mut node = Node::largest(self, ray)?;
        let mut left = path;
        while left != 0 {
            node = node.child(self, left & 15);
            left >>= 4;
        }
        Some(Meeting {
            distance: (2 * node.distance).max(0),
            path,
            normal: node.chord_or_foot(path).normal(true),
        })
    }

    /// Where a ray crosses any of the spheres, up to `reach`, in no order.
    /// `visit` is told of each, and says whether to go on.
    pub(crate) fn crossings(
        &self,
        ray: &Ray,
        from: Option<Start>,
        reach: Length,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(Length) -> bool,
    ) {
        let reach = i64::from(reach.to_bits()) << 28;
        self.walk(ray, reach, observer, &mut |chord| {
            let ends = match from.filter(|from| from.part == chord.path) {
                None => [chord.entry, chord.exit],
                // The light is on the inside, too, or comes in at the entry.
                Some(Start { inward: true, .. }) => [chord.entry, 0],
                Some(_) => [0, 0],
            };
            for distance in ends {
                if (1..reach).contains(&distance)
                    && !visit(Length::from_bits((distance >> 28) as i32))
                {
                    return 0;
                }
            }
            reach
        });
    }

    /// The outward unit normal of a hit.
    pub(crate) fn normal(&self, meeting: &Meeting) -> Vec3<Unit> {
        let mut normal = meeting.normal;
        let generations = (32 - meeting.path.leading_zeros()).div_ceil(4);
        for generation in (0..generations).rev() {
            normal = direction::outward(normal, meeting.path >> (4 * generation) & 15);
        }
        let [u, v, w] = self.axes();
        let along = |u: Unit, v: Unit, w: Unit| {
            let sum = u.product(normal.x) + v.product(normal.y) + w.product(normal.z);
            round_unit(sum.to_bits(), 30)
        };
        Vec3::new(
            along(u.x, v.x, w.x),
            along(u.y, v.y, w.y),
            along(u.z, v.z, w.z),
        )
        .renormalized()
    }

    /// Visits the spheres that the line of a ray passes through ahead of it,
    /// up to `reach`, roughly in order. `visit` says how far it reaches still:
    /// 0 to stop.
    #[inline(never)]
    fn walk(
        &self,
        ray: &Ray,
        mut reach: i64,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(&Chord) -> i64,
    ) {
        let (mut levels, mut children) = (Levels::new(), Children::new());
        let mut walk = Walk::new(self, &mut levels, &mut children);
        let mut next = Node::largest(self, ray).filter(|node| node.is_within(reach));
        while let Some(node) = next {
            observer.sphere();
            if let Some(chord) = node.chord(walk.path()) {
                reach = visit(&chord);
                if reach <= 0 {
                    return;
                }
            }
            next = walk.next(node, reach);
        }
    }
}
