//! The nearest surface that a ray meets.
//!
//! Distances are found first; normal and material follow for the nearest hit
//! alone. The common ray starts near and is answered by 32-bit distances. A
//! far hit, on something endless beyond all else, takes the cold path.

use core::borrow::Borrow;

use crate::Vec3;
use crate::num::{Length, NEAR_LIMIT, Scaled, Unit};
use crate::observer::Observer;
use crate::prepared::{Object, PreparedScene};
use crate::ray::{Point, Ray};
use crate::shape::{Path, Quadric, Shape, Sight, Sphereflake};

/// The nearest point of a ray on a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit<'s> {
    pub(crate) object: &'s Object,
    /// The object's number.
    pub(crate) index: u16,
    pub(crate) point: Point,
    /// Of a sphereflake; of any other object it says nothing.
    pub(crate) part: Part,
}

/// The sphere of a sphereflake, and its normal at the point.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Part {
    pub(crate) path: Path,
    pub(crate) normal: Vec3<Unit>,
}

/// The first surface that a ray meets.
#[inline(never)]
pub(crate) fn nearest<'s>(
    scene: &PreparedScene<'s>,
    ray: &Ray,
    observer: &mut impl Observer,
) -> Option<Hit<'s>> {
    observer.intersections(scene.objects.len() as u32);
    if !ray.origin.is_near() {
        return nearest_from_far(scene.objects, ray);
    }
    let from = ray.origin.coordinates;
    let seen = scene.objects.iter().enumerate();
    let seen = seen.map(|(index, object)| (index, object, object.shape.sight(from)));
    let nearest = nearest_near(seen, ray);
    or_far(nearest, scene.objects, ray)
}

/// The same for an eye ray, whose origin has looked at each object before.
#[inline(never)]
pub(crate) fn nearest_to_eye<'s>(
    scene: &PreparedScene<'s>,
    ray: &Ray,
    observer: &mut impl Observer,
) -> Option<Hit<'s>> {
    observer.intersections(scene.objects.len() as u32);
    let seen = scene.objects.iter().zip(scene.sights.eye).enumerate();
    let nearest = nearest_near(
        seen.map(|(index, (object, sight))| (index, object, sight)),
        ray,
    );
    or_far(nearest, scene.objects, ray)
}

#[inline(always)]
fn or_far<'s>(nearest: Option<Nearest<'s>>, objects: &'s [Object], ray: &Ray) -> Option<Hit<'s>> {
    match nearest {
        Some(nearest) => Some(nearest.hit(ray)),
        None => nearest_far(objects, ray),
    }
}

/// The nearest of the near hits.
struct Nearest<'s> {
    object: &'s Object,
    index: u16,
    distance: Length,
    part: Part,
}

impl<'s> Nearest<'s> {
    #[inline(always)]
    fn hit(&self, ray: &Ray) -> Hit<'s> {
        Hit {
            object: self.object,
            index: self.index,
            point: ray.at(self.distance),
            part: self.part,
        }
    }
}

/// Among hits less than [`NEAR_LIMIT`] away, from a near origin: of objects by
/// number, and how the origin sees them.
#[inline(always)]
fn nearest_near<'s>(
    seen: impl Iterator<Item = (usize, &'s Object, impl Borrow<Sight>)>,
    ray: &Ray,
) -> Option<Nearest<'s>> {
    let origin = ray.origin.coordinates;
    let mut limit = NEAR_LIMIT;
    let mut nearest = None;
    let mut part = Part::default();
    let start = usize::from(ray.start.object);
    for (index, object, sight) in seen {
        let sight = sight.borrow();
        let is_start = index == start;
        let distance = match &object.shape {
            Shape::Sphere(sphere) if is_start => ray
                .start
                .inward
                .then(|| sphere.across(origin, ray.direction)),
            Shape::Sphere(sphere) => sphere.distance(sight, ray.direction),
            Shape::Plane(_) if is_start => None,
            Shape::Plane(plane) => plane.distance(sight, ray, limit),
            Shape::Quadric(quadric) => quadric_distance(quadric, ray, is_start),
            Shape::Sphereflake(flake) => flake_distance(flake, ray, is_start, limit, &mut part),
        };
        if let Some(distance) = distance
            && distance < limit
        {
            limit = distance;
            nearest = Some((object, index));
        }
    }
    nearest.map(|(object, index)| Nearest {
        object,
        index: index as u16,
        distance: limit,
        part,
    })
}

#[inline(never)]
fn quadric_distance(quadric: &Quadric, ray: &Ray, is_start: bool) -> Option<Length> {
    quadric
        .nearest(ray, is_start.then_some(ray.start.inward))
        .and_then(Scaled::near)
        .filter(|distance| is_start || *distance > Length::ZERO)
}

/// The distance, below `limit`; what was met is written to `part`.
#[inline(never)]
fn flake_distance(
    flake: &Sphereflake,
    ray: &Ray,
    is_start: bool,
    limit: Length,
    part: &mut Part,
) -> Option<Length> {
    let meeting = flake.nearest(ray, is_start.then_some(ray.start), limit)?;
    let distance = meeting.distance();
    if distance < limit {
        *part = Part {
            path: meeting.path,
            normal: flake.normal(&meeting),
        };
    }
    Some(distance)
}

/// Among endless surfaces, at any distance, from any origin.
#[cold]
fn nearest_far<'s>(objects: &'s [Object], ray: &Ray) -> Option<Hit<'s>> {
    nearest_endless(objects, ray).map(|(hit, _)| hit)
}

fn nearest_endless<'s>(objects: &'s [Object], ray: &Ray) -> Option<(Hit<'s>, Scaled)> {
    let nearest = (0..)
        .zip(objects)
        .filter_map(|(index, object)| {
            let is_start = index == ray.start.object;
            let distance = match &object.shape {
                Shape::Plane(plane) if !is_start => plane.far_distance(ray),
                Shape::Quadric(quadric) if quadric.is_endless() => {
                    quadric.nearest(ray, is_start.then_some(ray.start.inward))
                }
                _ => None,
            };
            distance.map(|distance| (index, object, distance))
        })
        .min_by_key(|(.., distance)| *distance);
    let (index, object, distance) = nearest?;
    let hit = Hit {
        object,
        index,
        point: ray.far_at(distance),
        part: Part::default(),
    };
    Some((hit, distance))
}

/// From a far origin, outside of all finite geometry.
///
/// The ray goes on as a near one from shortly before it may meet finite
/// geometry; endless surfaces are looked for from its true origin.
#[cold]
fn nearest_from_far<'s>(objects: &'s [Object], ray: &Ray) -> Option<Hit<'s>> {
    let endless = nearest_endless(objects, ray);
    let finite = ray.approaching().and_then(|(ray, skipped)| {
        let from = ray.origin.coordinates;
        let finite = objects.iter().enumerate();
        let finite = finite.filter(|(_, object)| object.shape.is_finite());
        let seen = finite.map(|(index, object)| (index, object, object.shape.sight(from)));
        let nearest = nearest_near(seen, &ray)?;
        let distance = i64::from(nearest.distance.to_bits()) + skipped;
        Some((nearest.hit(&ray), distance))
    });
    match (finite, endless) {
        (Some((hit, distance)), Some((_, endless))) if distance <= endless.to_bits() => Some(hit),
        (_, Some((hit, _))) => Some(hit),
        (finite, None) => finite.map(|(hit, _)| hit),
    }
}
