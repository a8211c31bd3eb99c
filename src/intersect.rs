//! What a ray meets: the nearest surface, or all that dims a light.
//!
//! Distances are found first; normal and material follow for the nearest hit
//! alone. The common ray starts near and is answered by 32-bit distances. A
//! far hit, on a plane beyond all else, takes the cold path.

use crate::num::{Factor, Length, Scaled, Unit};
use crate::observer::{Observer, RayKind};
use crate::prepared::{Light, Object, PreparedScene};
use crate::ray::{Point, Ray, Start};
use crate::shape::{Plane, Shape, Sphere};
use crate::{Color, Vec3};

/// Distances below it are near; just below 8.
const LIMIT: Length = Length::from_bits(i32::MAX - 1024);

/// The nearest point of a ray on a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    /// The object's number.
    pub(crate) object: u16,
    pub(crate) point: Point,
}

/// The first surface that a ray meets.
#[inline]
pub(crate) fn nearest(
    scene: &PreparedScene<'_>,
    ray: &Ray,
    observer: &mut impl Observer,
) -> Option<Hit> {
    observer.intersections(scene.objects.len() as u32);
    if ray.origin.is_near() {
        match nearest_near(scene.objects, ray) {
            Some((object, distance)) => Some(Hit {
                object,
                point: ray.at(distance),
            }),
            None => nearest_far(scene.objects, ray),
        }
    } else {
        nearest_from_far(scene.objects, ray)
    }
}

/// Among hits less than [`LIMIT`] away, from a near origin.
#[inline]
fn nearest_near(objects: &[Object], ray: &Ray) -> Option<(u16, Length)> {
    let origin = ray.origin.coordinates;
    let mut limit = LIMIT;
    let mut nearest = None;
    for (index, object) in (0..).zip(objects) {
        let is_start = ray.start.object == index;
        let distance = match &object.shape {
            Shape::Sphere(sphere) if is_start => ray
                .start
                .inward
                .then(|| sphere.across(origin, ray.direction)),
            Shape::Sphere(sphere) => sphere.distance(origin, ray.direction),
            Shape::Plane(_) if is_start => None,
            Shape::Plane(plane) => plane.distance(ray, limit),
        };
        if let Some(distance) = distance
            && distance < limit
        {
            limit = distance;
            nearest = Some((index, distance));
        }
    }
    nearest
}

/// Among planes, at any distance, from any origin.
#[cold]
fn nearest_far(objects: &[Object], ray: &Ray) -> Option<Hit> {
    let (object, distance) = nearest_plane(objects, ray)?;
    Some(Hit {
        object,
        point: ray.far_at(distance),
    })
}

fn nearest_plane(objects: &[Object], ray: &Ray) -> Option<(u16, Scaled)> {
    (0..)
        .zip(objects)
        .filter(|(index, _)| *index != ray.start.object)
        .filter_map(|(index, object)| match &object.shape {
            Shape::Plane(plane) => plane.far_distance(ray).map(|distance| (index, distance)),
            Shape::Sphere(_) => None,
        })
        .min_by_key(|(_, distance)| (distance.exponent, distance.mantissa))
}

/// From a far origin, outside of all finite geometry.
///
/// The ray goes on as a near one from shortly before it may meet finite
/// geometry; planes are looked for from its true origin.
#[cold]
fn nearest_from_far(objects: &[Object], ray: &Ray) -> Option<Hit> {
    let plane = nearest_plane(objects, ray);
    let finite = ray.approaching().and_then(|(ray, skipped)| {
        let (object, distance) = nearest_finite(objects, &ray)?;
        Some((
            Hit {
                object,
                point: ray.at(distance),
            },
            i64::from(distance.to_bits()) + skipped,
        ))
    });
    match (finite, plane) {
        (Some((hit, distance)), Some((_, plane))) if distance <= plane.to_bits() => Some(hit),
        (_, Some((object, distance))) => Some(Hit {
            object,
            point: ray.far_at(distance),
        }),
        (finite, None) => finite.map(|(hit, _)| hit),
    }
}

fn nearest_finite(objects: &[Object], ray: &Ray) -> Option<(u16, Length)> {
    (0..)
        .zip(objects)
        .filter_map(|(index, object)| match &object.shape {
            Shape::Sphere(sphere) => sphere
                .distance(ray.origin.coordinates, ray.direction)
                .map(|distance| (index, distance)),
            Shape::Plane(_) => None,
        })
        .min_by_key(|(_, distance)| *distance)
}

/// The way from a light to a point of a surface.
///
/// Shadow rays are traced from the light: it is near, wherever the point is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowRay<'s> {
    pub(crate) light: &'s Light,
    /// From the light to the point.
    pub(crate) direction: Vec3<Unit>,
    /// To the point, if it is near; else the light's way passes all finite
    /// geometry.
    pub(crate) distance: Length,
    pub(crate) point: Point,
    /// The surface that the point is on; `inward` if it is lit from its inside.
    pub(crate) start: Start,
}

/// What is left of a light: each surface on the way lets its `kt` through.
///
/// `None` if an opaque one is among them.
#[inline]
pub(crate) fn transmittance(
    scene: &PreparedScene<'_>,
    shadow: &ShadowRay<'_>,
    observer: &mut impl Observer,
) -> Option<Color<Factor>> {
    observer.ray(RayKind::Shadow);
    let mut left = Color::WHITE;
    let mut tested = 0;
    for (index, object) in (0..).zip(scene.objects) {
        tested += 1;
        let is_start = shadow.start.object == index;
        let crossings = match &object.shape {
            Shape::Sphere(sphere) => sphere_crossings(sphere, shadow, is_start),
            Shape::Plane(_) if is_start => continue,
            Shape::Plane(plane) => [plane_crossing(plane, shadow), None],
        };
        for point in crossings.into_iter().flatten() {
            let kt = scene
                .material(object.texture.material(point))
                .map_or(Color::<Factor>::BLACK, |m| m.kt);
            if kt.is_black() {
                observer.intersections(tested);
                return None;
            }
            left = left.filtered(kt);
        }
    }
    observer.intersections(tested);
    Some(left)
}

#[inline]
fn sphere_crossings(sphere: &Sphere, shadow: &ShadowRay<'_>, is_start: bool) -> [Option<Point>; 2] {
    let light = shadow.light.position;
    if is_start && !shadow.start.inward {
        return [None, None];
    }
    let [entry, exit] = sphere.crossings(light, shadow.direction);
    let ray = Ray {
        origin: Point::near(light),
        direction: shadow.direction,
        start: Start::NOWHERE,
    };
    let before = |distance: &Length| *distance > Length::ZERO && *distance < shadow.distance;
    // From the inside of a sphere the exit is the lit point itself.
    let exit = if is_start { None } else { exit };
    [entry, exit].map(|crossing| crossing.filter(before).map(|distance| ray.at(distance)))
}

/// Light and point are on different sides: no distance is needed to know.
#[inline]
fn plane_crossing(plane: &Plane, shadow: &ShadowRay<'_>) -> Option<Point> {
    let light = Point::near(shadow.light.position);
    let (from, to) = (plane.depth(light), plane.depth(shadow.point));
    if (from < 0) == (to < 0) || from == 0 || to == 0 {
        return None;
    }
    let ray = Ray {
        origin: light,
        direction: shadow.direction,
        start: Start::NOWHERE,
    };
    let point = ray.far_at(plane.unbounded_distance(&ray)?);
    plane.covers(point).then_some(point)
}
