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
mod word;

pub(crate) use flake::{MAX_DEPTH as MAX_FLAKE_DEPTH, NodePath, Sphereflake, SphereflakeParams};

use crate::geometry::{OriginSurface, Ray};
use crate::math::{Length, Unit, Vec3, high};
use crate::observer::{Observer, ShapeKind};
use node::Node;
use walk::{Goal, Nodes, Waiting, Walk};

/// Where a ray meets the flake first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FlakeHit {
    /// Q60.
    distance: i64,
    pub(crate) path: NodePath,
    /// Outward, in the frame of the sphere.
    normal: Vec3<Unit>,
}

impl FlakeHit {
    /// Rounded, and above 0.
    pub(crate) fn distance(&self) -> Length {
        Length::from_bits(high(self.distance + (1 << 31)).max(1))
    }
}

impl Sphereflake {
    /// The nearest hit ahead, if it is below `limit`, of a ray that starts
    /// `from` one of the spheres or elsewhere.
    pub(crate) fn nearest(
        &self,
        ray: &Ray,
        from: Option<OriginSurface>,
        limit: Length,
        observer: &mut impl Observer,
    ) -> Option<FlakeHit> {
        let mut reach = i64::from(limit.to_bits()) << 32;
        let mut nearest = None;
        if let Some(from) = from.filter(|from| from.inward) {
            let across = self.across(ray, from.part, observer);
            let across = across.filter(|it| it.distance < reach);
            reach = across.map_or(reach, |it| it.distance);
            nearest = across;
        }
        let start = from.map_or(NO_PATH, |from| from.part);
        self.walk(ray, start, reach, Goal::Nearest, observer, &mut |node| {
            if node.path == start || !node.is_within(reach) {
                return reach;
            }
            let [entry, _, exit] = node.chord();
            for past_foot in [entry, exit] {
                let distance = node.distance_to(past_foot);
                if distance > 0 {
                    if distance < reach {
                        reach = distance;
                        nearest = Some(FlakeHit {
                            distance,
                            path: node.path,
                            normal: node.normal(past_foot),
                        });
                    }
                    break;
                }
            }
            reach
        });
        nearest
    }

    /// From a point on a sphere through its inside to the other end of the
    /// chord, which is a point where the ray grazes the sphere.
    #[cold]
    fn across(&self, ray: &Ray, path: NodePath, observer: &mut impl Observer) -> Option<FlakeHit> {
        let mut meeting = None;
        self.walk(ray, path, i64::MAX, Goal::Start, observer, &mut |node| {
            let [_, middle, exit] = node.chord();
            meeting = Some(FlakeHit {
                distance: (2 * node.distance_to(middle)).max(0),
                path,
                normal: node.normal(exit),
            });
            0
        });
        meeting
    }

    /// A sphere, as a ray sees it that sees the largest so.
    #[cold]
    #[inline(never)]
    fn part(&self, largest: &Node, path: NodePath) -> Node {
        let (mut node, mut left, mut generation) = (*largest, path, 0);
        while left != 0 {
            node = node.child(self, left & 15, 4 * generation);
            left >>= 4;
            generation += 1;
        }
        node
    }

    /// Whether a ray crosses any of the spheres before `reach`.
    pub(crate) fn is_between(
        &self,
        ray: &Ray,
        from: Option<OriginSurface>,
        reach: Length,
        observer: &mut impl Observer,
    ) -> bool {
        self.crossing(ray, from, reach, Goal::Any, observer, &mut |_| false)
    }

    /// Where a ray crosses any of the spheres, up to `reach`, in no order.
    /// `visit` is told of each, and says whether to go on.
    pub(crate) fn crossings(
        &self,
        ray: &Ray,
        from: Option<OriginSurface>,
        reach: Length,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(Length) -> bool,
    ) {
        self.crossing(ray, from, reach, Goal::All, observer, visit);
    }

    fn crossing(
        &self,
        ray: &Ray,
        from: Option<OriginSurface>,
        reach: Length,
        goal: Goal,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(Length) -> bool,
    ) -> bool {
        let reach = i64::from(reach.to_bits()) << 32;
        let start = from.map_or(NO_PATH, |from| from.part);
        self.walk(ray, start, reach, goal, observer, &mut |node| {
            let is_start = node.path == start;
            // The light is on the inside, too, or comes in at the entry.
            let is_left = is_start && from.is_some_and(|from| !from.inward);
            if is_left || !node.is_within(reach) {
                return reach;
            }
            let [entry, _, exit] = node.chord();
            for past_foot in [entry, exit] {
                let distance = node.distance_to(past_foot);
                if (1..reach).contains(&distance) && !visit(Length::from_bits(high(distance))) {
                    return 0;
                }
                if is_start {
                    break;
                }
            }
            reach
        })
    }

    /// The outward unit normal of a hit.
    pub(crate) fn normal(&self, meeting: &FlakeHit) -> Vec3<Unit> {
        let mut normal = meeting.normal.map(Unit::to_bits);
        let generations = (32 - meeting.path.leading_zeros()).div_ceil(4);
        for generation in (0..generations).rev() {
            normal = direction::outward(normal, meeting.path >> (4 * generation) & 15);
        }
        self.outward(normal.map(Unit::from_bits)).renormalized()
    }

    /// Visits the spheres that the line of a ray passes through ahead of it,
    /// up to `reach`, roughly in order, but those that the goal needs not.
    /// `visit` says how far it reaches still: 0 to stop. Tells whether it did,
    /// or is sure that any is hit.
    #[inline(never)]
    fn walk(
        &self,
        ray: &Ray,
        start: NodePath,
        reach: i64,
        goal: Goal,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(&Node) -> i64,
    ) -> bool {
        let Some(node) = Node::largest(self, ray, reach) else {
            return false;
        };
        let (mut nodes, mut waiting) = (Nodes::new(), Waiting::new());
        let _ = nodes.push(node);
        let mut walk = Walk {
            flake: self,
            nodes: &mut nodes,
            waiting: &mut waiting,
            goal,
            start,
            reach: high(reach),
        };
        while let Some(node) = walk.nodes.last() {
            if goal == Goal::Start {
                visit(&self.part(node, start));
                return true;
            }
            let squared = node.squared();
            let is_crossed = squared < 1 << 58;
            observer.test(ShapeKind::Sphereflake, is_crossed);
            if is_crossed {
                let reach = visit(node);
                if reach <= 0 {
                    return true;
                }
                walk.reach = walk.reach.min(high(reach));
            }
            if walk.descend(squared) {
                return true;
            }
            if walk.next().is_none() {
                break;
            }
        }
        false
    }
}

/// Of no sphere: children are 1 to 12.
const NO_PATH: NodePath = NodePath::MAX;
