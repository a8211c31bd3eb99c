//! Finds the nearest hit of a ray.
//!
//! The distances to all objects are computed first. The normal and the material are computed only
//! for the nearest hit. Distances have 32 bits if the ray starts in the near range (coordinates
//! within ±3.5). A separate, slower path finds hits outside the near range. Only unbounded objects
//! can have such hits.

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
    /// True if the ray starts in the near range (coordinates within ±3.5) and the hit may be in
    /// this range too.
    pub(crate) is_near: bool,
    /// Distance from the origin of the ray to the hit. The distance is valid if `is_near` is true.
    /// It is also valid if the object is bounded and the ray starts in the extended range. In this
    /// case, the distance is measured from the origin of [`Ray::moved_near`].
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
            // The ray is inside an isolated sphere, so it cannot hit any other object.
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

    /// Intersects a ray with all objects of the scene. Bounded objects are tested in groups. The
    /// ray may start anywhere, and the scene may have any number of objects.
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

    /// Intersects a camera ray with the given objects, the only objects that it may hit.
    #[inline(always)]
    pub(super) fn intersect_candidates(&mut self, objects: &[u16], ray: &Ray) -> Option<Hit> {
        let mut nearest = Nearest::NONE;
        for &object in objects {
            self.test(&mut nearest, object, ray);
        }
        self.finish(&nearest, ray)
    }

    /// Tests a ray against bounded objects. Skips objects whose bounding spheres the ray cannot
    /// hit. Also skips the object that the ray has just left, if the ray cannot hit that object
    /// again.
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

    /// Returns the distance from the origin of a ray to an object. The distance is exact if it is
    /// below `limit`. The distance is [`Length::MAX`] if the ray may hit the object outside the
    /// near range (coordinates within ±3.5).
    ///
    /// This function is not inlined. Otherwise, LLVM moves code out of the loops that call it. The
    /// loops are so short that moving the code costs more time than it saves.
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
            let distance = object.shape.intersect_extended(ray, is_origin);
            self.observer.test(object.shape.kind(), distance.is_some());
            Some((index, distance?))
        });
        let (object, distance) = hits.min_by_key(|(_, distance)| *distance)?;
        let hit = Hit {
            object,
            is_near: false,
            distance: Length::MAX,
        };
        Some((hit, distance))
    }

    /// Intersects a ray that starts in the extended range. The origin of the ray is outside all
    /// bounded objects.
    ///
    /// To test bounded objects, the origin of the ray is moved to a point shortly before these
    /// objects. To test unbounded objects, the true origin is used.
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
