//! Finds the nearest hit of a ray.
//!
//! The distances to all objects are computed first. The normal and the material are computed
//! only for the nearest hit. If the ray starts in the near range (coordinates within ±3.5),
//! distances have 32 bits. A separate, slower path finds hits outside this range, which only
//! unbounded objects can have.

use super::tracer::Tracer;
use crate::geometry::{CullSphere, OriginSurface, Point, Ray, SurfaceFlags, to_q12, to_q16};
use crate::math::{Length, NEAR_LIMIT, SoftFloat};
use crate::observer::Observer;
use crate::prepare::{GROUP, Object, SMALL_SCENE};

/// The nearest hit of a ray on any object.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    /// Index of the object that the ray hits.
    pub(crate) object: u16,
    /// True if the origin of the ray is in the near range (coordinates within ±3.5) and the hit
    /// may be in it too.
    pub(crate) is_near: bool,
    /// Distance from the origin of the ray to the hit. The distance is valid if the hit is
    /// near. It is also valid if the object is bounded and the ray starts in the extended
    /// range, but then it is measured from the origin of [`Ray::moved_near`].
    pub(super) distance: Length,
}

impl Hit {
    /// Returns the hit point of a hit that is not near.
    #[cold]
    pub(super) fn extended_point(self, object: &Object, ray: &Ray) -> Point {
        let is_origin = self.object == ray.leaves.object;
        if let Some(distance) = object.shape.intersect_extended(ray, is_origin) {
            return ray.at_extended(distance);
        }
        let near = ray.moved_near().map_or(*ray, |(near, _)| near);
        near.at(self.distance)
    }
}

/// The nearest hit that has been found so far.
struct Nearest {
    object: u16,
    /// Distance to the nearest hit so far.
    limit: Length,
    /// True if the ray may hit an unbounded object outside the near range (coordinates within
    /// ±3.5).
    is_extended: bool,
}

impl Nearest {
    const NONE: Self = Self {
        object: OriginSurface::NONE.object,
        limit: NEAR_LIMIT,
        is_extended: false,
    };
}

impl<O: Observer> Tracer<'_, '_, O> {
    /// Intersects a secondary ray with all objects of the scene.
    #[inline(always)]
    pub(super) fn intersect(&mut self, ray: &Ray) -> Option<Hit> {
        let OriginSurface {
            object,
            skipped,
            is_inside,
            flags,
            ..
        } = ray.leaves;
        if cfg!(feature = "glass") && is_inside && flags.intersects(SurfaceFlags::ISOLATED) {
            // The ray is inside an isolated sphere, so it can only hit this sphere, from
            // inside.
            let distance = self.distance(object, ray, NEAR_LIMIT)?;
            return Some(Hit {
                object,
                is_near: true,
                distance,
            });
        }
        let scene = self.scene;
        if !ray.origin.is_near() || scene.bounded.len() > SMALL_SCENE {
            return self.intersect_any(ray);
        }
        let mut nearest = Nearest::NONE;
        self.test_bounded(&mut nearest, scene.bounded, ray);
        for &object in scene.unbounded {
            if object != skipped {
                self.test(&mut nearest, object, ray);
            }
        }
        self.finish(&nearest, ray)
    }

    /// Intersects a ray with all objects of the scene, group by group. The ray may start
    /// anywhere, and the scene may have any number of objects.
    pub(super) fn intersect_any(&mut self, ray: &Ray) -> Option<Hit> {
        if !ray.origin.is_near() {
            return self.intersect_from_extended(ray);
        }
        let scene = self.scene;
        let mut nearest = Nearest::NONE;
        let (origin, direction) = (to_q12(ray.origin.coordinates), to_q16(ray.direction));
        for (group, members) in scene.groups.iter().zip(scene.bounded.chunks(GROUP)) {
            if group.may_hit(origin, direction) {
                self.test_group(&mut nearest, members, ray);
            }
        }
        for &object in scene.unbounded {
            if object != ray.leaves.skipped {
                self.test(&mut nearest, object, ray);
            }
        }
        self.finish(&nearest, ray)
    }

    /// Intersects a camera ray with the objects in a list of those that it may hit.
    #[inline(always)]
    pub(super) fn intersect_candidates(&mut self, objects: &[u16], ray: &Ray) -> Option<Hit> {
        let mut nearest = Nearest::NONE;
        for &object in objects {
            self.test(&mut nearest, object, ray);
        }
        self.finish(&nearest, ray)
    }

    /// Tests a ray against bounded objects. An object is tested only if the ray may hit its
    /// bounding sphere, and if it is not the object that the ray has left and cannot hit again.
    #[inline(always)]
    fn test_bounded(&mut self, nearest: &mut Nearest, spheres: &[CullSphere], ray: &Ray) {
        let origin = to_q12(ray.origin.coordinates);
        let direction = to_q16(ray.direction);
        let skipped = ray.leaves.skipped;
        for sphere in spheres {
            if sphere.may_hit(origin, direction) && sphere.object != skipped {
                self.test(nearest, sphere.object, ray);
            }
        }
    }

    fn test_group(&mut self, nearest: &mut Nearest, spheres: &[CullSphere], ray: &Ray) {
        self.test_bounded(nearest, spheres, ray);
    }

    #[inline(always)]
    fn test(&mut self, nearest: &mut Nearest, object: u16, ray: &Ray) {
        let Some(distance) = self.distance(object, ray, nearest.limit) else {
            return;
        };
        if distance < nearest.limit {
            nearest.limit = distance;
            nearest.object = object;
        } else {
            nearest.is_extended |= distance == Length::MAX;
        }
    }

    /// Returns the distance to an object. The distance is exact if it is below `limit`. It is
    /// [`Length::MAX`] if the object may be hit outside the near range (coordinates within
    /// ±3.5).
    ///
    /// Kept out of line: otherwise LLVM hoists code out of the loops that call this function.
    /// The loops are so short that this costs more than it saves.
    fn distance(&mut self, object: u16, ray: &Ray, limit: Length) -> Option<Length> {
        let is_origin = object == ray.leaves.object;
        let object = self.scene.objects.get(usize::from(object))?;
        object
            .shape
            .intersect(ray, is_origin, limit, self.part, self.observer)
    }

    #[inline(always)]
    fn finish(&mut self, nearest: &Nearest, ray: &Ray) -> Option<Hit> {
        if nearest.limit < NEAR_LIMIT {
            return Some(Hit {
                object: nearest.object,
                is_near: true,
                distance: nearest.limit,
            });
        }
        if nearest.is_extended {
            return self.intersect_unbounded(ray).map(|(hit, _)| hit);
        }
        None
    }

    /// Intersects a ray with all unbounded objects, at any distance. The ray may start
    /// anywhere.
    #[cold]
    fn intersect_unbounded(&mut self, ray: &Ray) -> Option<(Hit, SoftFloat)> {
        let scene = self.scene;
        let hits = scene.unbounded.iter().filter_map(|&index| {
            let object = scene.objects.get(usize::from(index))?;
            let is_origin = index == ray.leaves.object;
            let distance = object.shape.intersect_extended(ray, is_origin)?;
            Some((index, distance))
        });
        let (object, distance) = hits.min_by_key(|(_, distance)| *distance)?;
        let hit = Hit {
            object,
            is_near: false,
            distance: Length::MAX,
        };
        Some((hit, distance))
    }

    /// Intersects a ray that starts in the extended range, outside all bounded geometry.
    ///
    /// For tests against bounded objects, the origin of the ray is moved to a point shortly
    /// before these objects. Unbounded objects are tested with the true origin.
    #[cold]
    fn intersect_from_extended(&mut self, ray: &Ray) -> Option<Hit> {
        let unbounded = self.intersect_unbounded(ray);
        let bounded = self.intersect_bounded_from_extended(ray);
        match (bounded, unbounded) {
            (Some((hit, distance)), Some((_, unbounded))) if distance <= unbounded.to_bits() => {
                Some(hit)
            }
            (_, Some((hit, _))) => Some(hit),
            (bounded, None) => bounded.map(|(hit, _)| hit),
        }
    }

    fn intersect_bounded_from_extended(&mut self, ray: &Ray) -> Option<(Hit, i64)> {
        let (ray, skipped) = ray.moved_near()?;
        let mut nearest = Nearest::NONE;
        self.test_group(&mut nearest, self.scene.bounded, &ray);
        let distance = i64::from(nearest.limit.to_bits()) + skipped;
        let hit = self.finish(&nearest, &ray)?;
        let is_near = false;
        Some((Hit { is_near, ..hit }, distance))
    }
}
