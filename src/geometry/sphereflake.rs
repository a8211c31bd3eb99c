//! The sphereflake, a fractal in which every sphere is touched by twelve smaller ones (Haines
//! 1987).
//!
//! The spheres are not stored. They form a tree, which a ray traverses from the root sphere, nearer
//! children first. The traversal skips a subtree if the ray misses the bounding sphere of the
//! subtree. Every level of the tree has its own frame and unit of length, so the smallest sphere is
//! as exact as the largest. The memory of the traversal grows in proportion to the depth of the
//! tree.

pub(super) mod authored;
mod child_frame;
mod error_bounds;
mod node;
mod parameters;
mod traversal;

use super::bounding_sphere::BoundingSphere;
use super::point::Point;
use super::primitive::{Primitive, PrimitivePart, SurfacePoint};
use super::ray::Ray;
use super::shadow_segment::ShadowSegment;
use super::surface::{OriginSurface, SurfaceFlags};
use crate::archive;
use crate::archive::{Archive, Fields};
use crate::math::{Length, Unit, Vec3, high};
use crate::observer::{Observer, ShapeKind};
use node::Node;
pub(crate) use parameters::Sphereflake;
use parameters::{NodePath, SphereflakeParams};
use traversal::{NodeStack, PendingChildren, Query, Traversal};

/// Tag of a sphereflake in a compiled scene.
pub(super) const TAG: u8 = 7;

/// A path that no sphere has, because children are numbered from 1 to 12.
const NO_PATH: NodePath = NodePath::MAX;

/// A hit of a ray on a sphere of the flake.
#[derive(Clone, Copy, Debug)]
struct FlakeHit {
    /// Distance from the origin of the ray, in Q60.
    distance: i64,
    path: NodePath,
    /// Outward unit normal, in the frame of the sphere.
    normal: Vec3<Unit>,
}

impl FlakeHit {
    /// Returns the distance of the hit, rounded, and at least 2^-28.
    fn distance(&self) -> Length {
        Length::from_bits(high(self.distance + (1 << 31)).max(1))
    }
}

impl Sphereflake {
    /// Tag of the flake in a compiled scene.
    pub(super) fn tag(&self) -> u8 {
        TAG
    }

    /// Returns the nearest hit of a ray before the distance `limit`. If the ray leaves a sphere of
    /// this flake, `origin` is the surface of that sphere.
    fn nearest(
        &self,
        ray: &Ray,
        origin: Option<OriginSurface>,
        limit: Length,
        observer: &mut impl Observer,
    ) -> Option<FlakeHit> {
        let mut t_max = i64::from(limit.to_bits()) << 32;
        let mut nearest = None;
        if let Some(origin) = origin.filter(|origin| origin.is_inside) {
            let exit = self.exit(ray, origin.part, observer);
            let exit = exit.filter(|hit| hit.distance < t_max);
            t_max = exit.map_or(t_max, |hit| hit.distance);
            nearest = exit;
        }
        let origin = origin.map_or(NO_PATH, |origin| origin.part);
        self.traverse(ray, origin, t_max, Query::Nearest, observer, &mut |node| {
            if node.path == origin || !node.is_within(t_max) {
                return t_max;
            }
            let [entry, _, exit] = node.chord();
            for past_foot in [entry, exit] {
                let distance = node.distance_to(past_foot);
                if distance > 0 {
                    if distance < t_max {
                        t_max = distance;
                        nearest = Some(FlakeHit {
                            distance,
                            path: node.path,
                            normal: node.normal(past_foot),
                        });
                    }
                    break;
                }
            }
            t_max
        });
        nearest
    }

    /// Returns the exit of a ray that starts on a sphere and runs through the inside of that
    /// sphere. The exit is the other end of the chord. If the ray only grazes the sphere, the exit
    /// is the origin of the ray.
    #[cold]
    fn exit(&self, ray: &Ray, path: NodePath, observer: &mut impl Observer) -> Option<FlakeHit> {
        let mut hit = None;
        self.traverse(ray, path, i64::MAX, Query::Origin, observer, &mut |node| {
            let [_, middle, exit] = node.chord();
            hit = Some(FlakeHit {
                distance: (2 * node.distance_to(middle)).max(0),
                path,
                normal: node.normal(exit),
            });
            0
        });
        hit
    }

    /// Returns the node of the sphere with the given path. `root` is the node of the root sphere.
    #[cold]
    #[inline(never)]
    fn node_at(&self, root: &Node, path: NodePath) -> Node {
        let (mut node, mut rest, mut generation) = (*root, path, 0);
        while rest != 0 {
            node = node.child(self, rest & 15, 4 * generation);
            rest >>= 4;
            generation += 1;
        }
        node
    }

    /// Calls `visit` with each distance up to `t_max` at which a ray crosses the surface of a
    /// sphere. The distances come in no particular order. If `visit` returns false, the traversal
    /// stops. Returns true if the traversal stopped early.
    ///
    /// With [`Query::Any`], the traversal may stop as soon as a crossing is certain, without a call
    /// of `visit`.
    fn crossings(
        &self,
        ray: &Ray,
        origin: Option<OriginSurface>,
        t_max: Length,
        query: Query,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(Length) -> bool,
    ) -> bool {
        let t_max = i64::from(t_max.to_bits()) << 32;
        let path = origin.map_or(NO_PATH, |origin| origin.part);
        self.traverse(ray, path, t_max, query, observer, &mut |node| {
            let is_origin = node.path == path;
            // If the lit point is on the outside of this sphere, the sphere is skipped. If the lit
            // point is on the inside, only the entry of the ray counts, because the exit is the lit
            // point.
            let is_left = is_origin && origin.is_some_and(|origin| !origin.is_inside);
            if is_left || !node.is_within(t_max) {
                return t_max;
            }
            let [entry, _, exit] = node.chord();
            for past_foot in [entry, exit] {
                let distance = node.distance_to(past_foot);
                if (1..t_max).contains(&distance) && !visit(Length::from_bits(high(distance))) {
                    return 0;
                }
                if is_origin {
                    break;
                }
            }
            t_max
        })
    }

    /// Returns the outward unit normal at a hit, in the frame of the scene.
    fn normal_of(&self, hit: &FlakeHit) -> Vec3<Unit> {
        let mut normal = hit.normal.map(Unit::to_bits);
        let generations = (32 - hit.path.leading_zeros()).div_ceil(4);
        for generation in (0..generations).rev() {
            normal = child_frame::to_parent(normal, hit.path >> (4 * generation) & 15);
        }
        self.local_to_world(normal.map(Unit::from_bits))
            .renormalized()
    }

    /// Calls `visit` with each sphere that the line of a ray crosses between the origin of the ray
    /// and the distance `t_max`. The spheres come roughly in order of distance. Spheres that the
    /// query does not need are skipped. `visit` returns the new `t_max`, or 0 to stop. Returns true
    /// if the traversal stopped early, also because the observer interrupted it.
    #[inline(never)]
    fn traverse(
        &self,
        ray: &Ray,
        origin: NodePath,
        t_max: i64,
        query: Query,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(&Node) -> i64,
    ) -> bool {
        let Some(root) = Node::root(self, ray, t_max) else {
            return false;
        };
        let (mut nodes, mut pending) = (NodeStack::new(), PendingChildren::new());
        let _ = nodes.push(root);
        let mut traversal = Traversal {
            flake: self,
            nodes: &mut nodes,
            pending: &mut pending,
            query,
            origin,
            t_max: high(t_max),
        };
        while let Some(node) = traversal.nodes.last() {
            if query == Query::Origin {
                visit(&self.node_at(node, origin));
                return true;
            }
            let foot_squared = node.foot_squared();
            let is_crossed = foot_squared < 1 << 58;
            observer.test(ShapeKind::Sphereflake, is_crossed);
            if observer.is_interrupted() {
                return true;
            }
            if is_crossed {
                let t_max = visit(node);
                if t_max <= 0 {
                    return true;
                }
                traversal.t_max = traversal.t_max.min(high(t_max));
            }
            if traversal.descend(foot_squared) {
                return true;
            }
            if traversal.advance().is_none() {
                break;
            }
        }
        false
    }
}

impl Primitive for Sphereflake {
    /// Returns true if the radius is positive. If a parameter is invalid, decoding sets the radius
    /// to 0.
    fn is_valid(&self) -> bool {
        self.radius > 0
    }

    fn kind(&self) -> ShapeKind {
        ShapeKind::Sphereflake
    }

    fn flags(&self) -> SurfaceFlags {
        SurfaceFlags::BOUNDED
    }

    fn bounding_sphere(&self) -> Option<BoundingSphere> {
        Some(BoundingSphere {
            center: self.center,
            radius: self.reach(),
        })
    }

    #[inline(never)]
    fn intersect(
        &self,
        ray: &Ray,
        is_origin: bool,
        limit: Length,
        part: &mut PrimitivePart,
        observer: &mut impl Observer,
    ) -> Option<Length> {
        let hit = self.nearest(ray, is_origin.then_some(ray.leaves), limit, observer)?;
        let distance = hit.distance();
        if distance < limit {
            *part = PrimitivePart {
                id: hit.path,
                normal: self.normal_of(&hit),
            };
        }
        Some(distance)
    }

    fn surface_at(&self, _: &Point, part: &PrimitivePart) -> SurfacePoint {
        SurfacePoint {
            normal: part.normal,
            part: part.id,
        }
    }

    #[inline(always)]
    fn count_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        any: bool,
        observer: &mut impl Observer,
    ) -> Option<u8> {
        let crosses = || {
            let origin = is_origin.then_some(segment.ray.leaves);
            let (ray, t_max) = (segment.to_ray(), segment.near_length());
            self.crossings(&ray, origin, t_max, Query::Any, observer, &mut |_| false)
        };
        any.then(crosses).map(u8::from)
    }

    fn visit_crossings(
        &self,
        segment: &ShadowSegment<'_>,
        is_origin: bool,
        observer: &mut impl Observer,
        visit: &mut dyn FnMut(Point) -> bool,
    ) {
        let origin = is_origin.then_some(segment.ray.leaves);
        let (ray, t_max) = (segment.to_ray(), segment.near_length());
        let mut visit = |distance| visit(ray.at(distance));
        self.crossings(&ray, origin, t_max, Query::All, observer, &mut visit);
    }
}

impl Fields for Sphereflake {
    fn visit(&mut self, archive: &mut impl Archive) {
        let SphereflakeParams {
            mut center,
            mut frame,
            mut radius,
            mut ratio,
            mut depth,
        } = self.params();
        archive::vector(&mut center, archive);
        frame
            .iter_mut()
            .for_each(|row| archive::vector(row, archive));
        archive::fixed(&mut radius, archive);
        archive::fixed(&mut ratio, archive);
        depth.visit(archive);
        let params = SphereflakeParams {
            center,
            frame,
            radius,
            ratio,
            depth,
        };
        // The derived constants of a flake can be computed only if its parameters are valid.
        *self = if params.is_valid() {
            Self::new(params)
        } else {
            Self::default()
        };
    }
}
