//! The nearest surface that a ray meets.
//!
//! Distances are found first; normal and material follow for the nearest hit
//! alone. The common ray starts near and is answered by 32-bit distances. A
//! far hit, on something endless beyond all else, takes the cold path.

use crate::geometry::{
    CullSphere, NodePath, OriginSurface, Point, Quadric, Ray, Shape, Sphereflake, SurfaceFlags,
    are_near, coarse, narrow,
};
use crate::math::{Length, NEAR_LIMIT, SoftFloat, Unit, Vec3};
use crate::observer::{Observer, ShapeKind};
use crate::prepare::culling::{FEW, GROUP};
use crate::prepare::{Object, PreparedScene};

/// The nearest surface of a ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    /// The object's number.
    pub(crate) object: u16,
    /// Whether both the ray's origin and the surface are near.
    pub(crate) is_near: bool,
    /// How far the surface is from the origin if so; else, if it is finite, from where the ray
    /// is [`Ray::approaching`].
    distance: Length,
}

impl Hit {
    /// Moves a ray on to the point of the surface.
    #[inline(always)]
    pub(crate) fn reach(self, object: &Object, ray: &mut Ray) {
        if !self.is_near {
            ray.origin = self.far_point(object, ray);
            return;
        }
        let is_near = match &object.shape {
            Shape::Sphere(_) => true,
            Shape::Plane(plane) => plane.is_near(),
            _ => false,
        };
        let coordinates = ray.near_at(self.distance);
        if is_near || are_near(coordinates) {
            ray.origin.coordinates = coordinates;
        } else {
            ray.origin = ray.far_at(SoftFloat::unordered(self.distance));
        }
    }

    #[cold]
    fn far_point(self, object: &Object, ray: &Ray) -> Point {
        let is_start = self.object == ray.start.object;
        if let Some(distance) = endless_distance(object, ray, is_start) {
            return ray.far_at(distance);
        }
        let near = ray.approaching().map_or(*ray, |(near, _)| near);
        near.at(self.distance)
    }
}

/// The sphere of a sphereflake that is hit, and its normal at the point.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PrimitivePart {
    pub(crate) path: NodePath,
    pub(crate) normal: Vec3<Unit>,
}

/// The first surface that a ray meets. What is met of a flake is written to `part`.
#[inline(always)]
pub(crate) fn nearest(
    scene: &PreparedScene<'_>,
    ray: &Ray,
    part: &mut PrimitivePart,
    observer: &mut impl Observer,
) -> Option<Hit> {
    if ray.start.inward
        && ray.start.nature.is(SurfaceFlags::ALONE)
        && let Shape::Sphere(sphere) = &scene.object(ray.start.object).shape
    {
        observer.test(ShapeKind::Sphere, true);
        return Some(Hit {
            object: ray.start.object,
            is_near: true,
            distance: sphere.across(ray.origin.coordinates, ray.direction),
        });
    }
    if !ray.origin.is_near() || scene.finite.len() > FEW {
        return nearest_of_many(scene, ray, part, observer);
    }
    let mut nearest = Nearest::new(scene, ray, part);
    let left = ray.start.left;
    nearest.meet_finite(scene.finite, left, observer);
    for &object in scene.endless {
        if object != left {
            nearest.meet(object, observer);
        }
    }
    nearest.hit(observer)
}

/// The same from anywhere, among any number of objects: by their groups.
#[inline(never)]
pub(crate) fn nearest_of_many(
    scene: &PreparedScene<'_>,
    ray: &Ray,
    part: &mut PrimitivePart,
    observer: &mut impl Observer,
) -> Option<Hit> {
    if !ray.origin.is_near() {
        return nearest_from_far(scene, ray, part, observer);
    }
    let mut nearest = Nearest::new(scene, ray, part);
    let (origin, direction) = (coarse(ray.origin.coordinates), narrow(ray.direction));
    let left = ray.start.left;
    for (group, members) in scene.groups.iter().zip(scene.finite.chunks(GROUP)) {
        if group.may_meet(origin, direction) {
            nearest.meet_group(members, left, observer);
        }
    }
    for &object in scene.endless {
        if object != left {
            nearest.meet(object, observer);
        }
    }
    nearest.hit(observer)
}

/// The same for an eye ray, which may meet some objects only.
#[inline(always)]
pub(crate) fn nearest_of(
    objects: &[u16],
    scene: &PreparedScene<'_>,
    ray: &Ray,
    part: &mut PrimitivePart,
    observer: &mut impl Observer,
) -> Option<Hit> {
    let mut nearest = Nearest::new(scene, ray, part);
    for &object in objects {
        nearest.meet(object, observer);
    }
    nearest.hit(observer)
}

/// The nearest of the near hits.
struct Nearest<'r> {
    scene: &'r PreparedScene<'r>,
    ray: &'r Ray,
    part: &'r mut PrimitivePart,
    object: u16,
    limit: Length,
    /// Whether there is a hit that is not near.
    is_far: bool,
}

impl<'r> Nearest<'r> {
    #[inline(always)]
    fn new(scene: &'r PreparedScene<'r>, ray: &'r Ray, part: &'r mut PrimitivePart) -> Self {
        Self {
            scene,
            ray,
            part,
            object: OriginSurface::NOWHERE.object,
            limit: NEAR_LIMIT,
            is_far: false,
        }
    }

    /// Looks at finite objects whose bounds the ray meets, but for the one
    /// that it has left for good.
    #[inline(always)]
    fn meet_finite(&mut self, objects: &[CullSphere], left: u16, observer: &mut impl Observer) {
        let origin = coarse(self.ray.origin.coordinates);
        let direction = narrow(self.ray.direction);
        for around in objects {
            if around.may_meet(origin, direction) && around.object != left {
                self.meet(around.object, observer);
            }
        }
    }

    /// The same for those of many.
    #[inline(never)]
    fn meet_group(&mut self, objects: &[CullSphere], left: u16, observer: &mut impl Observer) {
        self.meet_finite(objects, left, observer);
    }

    /// Looks at an object.
    #[inline(always)]
    fn meet(&mut self, number: u16, observer: &mut impl Observer) {
        let Some(distance) = distance(
            number, self.scene, self.ray, self.limit, self.part, observer,
        ) else {
            return;
        };
        if distance < self.limit {
            self.limit = distance;
            self.object = number;
        } else {
            self.is_far |= distance == Length::MAX;
        }
    }

    #[inline(always)]
    fn hit(&self, observer: &mut impl Observer) -> Option<Hit> {
        if self.limit < NEAR_LIMIT {
            return Some(Hit {
                object: self.object,
                is_near: true,
                distance: self.limit,
            });
        }
        if self.is_far {
            return nearest_endless(self.scene, self.ray, observer).map(|(hit, _)| hit);
        }
        None
    }
}

/// How far an object is, exact if that is below `limit`; [`Length::MAX`] if it is not near.
///
/// Not inlined: in a loop of few turns, what would be prepared before it
/// costs more than it saves.
#[inline(never)]
fn distance(
    number: u16,
    scene: &PreparedScene<'_>,
    ray: &Ray,
    limit: Length,
    part: &mut PrimitivePart,
    observer: &mut impl Observer,
) -> Option<Length> {
    let object = scene.objects.get(usize::from(number))?;
    let is_start = number == ray.start.object;
    let origin = ray.origin.coordinates;
    let distance = match &object.shape {
        Shape::Sphere(sphere) if is_start => Some(sphere.across(origin, ray.direction)),
        Shape::Sphere(sphere) => sphere.distance(origin, ray.direction),
        Shape::Plane(plane) => plane.distance(ray, limit),
        Shape::Quadric(quadric) => quadric_distance(quadric, ray, is_start),
        Shape::Sphereflake(flake) => flake_distance(flake, ray, is_start, limit, part, observer),
    };
    observer.test(object.shape.kind(), distance.is_some());
    distance
}

#[inline(never)]
fn quadric_distance(quadric: &Quadric, ray: &Ray, is_start: bool) -> Option<Length> {
    quadric
        .nearest(ray, is_start.then_some(ray.start.inward))
        .map(|distance| distance.near().unwrap_or(Length::MAX))
        .filter(|distance| is_start || *distance > Length::ZERO)
}

/// The distance, below `limit`; what was met is written to `part`.
#[inline(never)]
fn flake_distance(
    flake: &Sphereflake,
    ray: &Ray,
    is_start: bool,
    limit: Length,
    part: &mut PrimitivePart,
    observer: &mut impl Observer,
) -> Option<Length> {
    let meeting = flake.nearest(ray, is_start.then_some(ray.start), limit, observer)?;
    let distance = meeting.distance();
    if distance < limit {
        *part = PrimitivePart {
            path: meeting.path,
            normal: flake.normal(&meeting),
        };
    }
    Some(distance)
}

/// Among endless surfaces, at any distance, from any origin.
#[cold]
#[inline(never)]
fn nearest_endless(
    scene: &PreparedScene<'_>,
    ray: &Ray,
    observer: &mut impl Observer,
) -> Option<(Hit, SoftFloat)> {
    let met = scene.endless.iter().filter_map(|&number| {
        let object = scene.objects.get(usize::from(number))?;
        let is_start = number == ray.start.object;
        let distance = endless_distance(object, ray, is_start);
        observer.test(object.shape.kind(), distance.is_some());
        Some((number, distance?))
    });
    let (object, distance) = met.min_by_key(|(_, distance)| *distance)?;
    let hit = Hit {
        object,
        is_near: false,
        distance: Length::MAX,
    };
    Some((hit, distance))
}

/// How far an endless surface is, at any distance.
#[inline(never)]
fn endless_distance(object: &Object, ray: &Ray, is_start: bool) -> Option<SoftFloat> {
    match &object.shape {
        Shape::Plane(plane) if !is_start => plane.far_distance(ray),
        Shape::Quadric(quadric) if quadric.is_endless() => {
            quadric.nearest(ray, is_start.then_some(ray.start.inward))
        }
        _ => None,
    }
}

/// From a far origin, outside of all finite geometry.
///
/// The ray goes on as a near one from shortly before it may meet finite
/// geometry; endless surfaces are looked for from its true origin.
#[cold]
fn nearest_from_far(
    scene: &PreparedScene<'_>,
    ray: &Ray,
    part: &mut PrimitivePart,
    observer: &mut impl Observer,
) -> Option<Hit> {
    let endless = nearest_endless(scene, ray, observer);
    let finite = ray.approaching().and_then(|(ray, skipped)| {
        let mut nearest = Nearest::new(scene, &ray, part);
        nearest.meet_group(scene.finite, ray.start.left, observer);
        let distance = i64::from(nearest.limit.to_bits()) + skipped;
        let hit = nearest.hit(observer)?;
        let is_near = false;
        Some((Hit { is_near, ..hit }, distance))
    });
    match (finite, endless) {
        (Some((hit, distance)), Some((_, endless))) if distance <= endless.to_bits() => Some(hit),
        (_, Some((hit, _))) => Some(hit),
        (finite, None) => finite.map(|(hit, _)| hit),
    }
}
