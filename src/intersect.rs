//! What a ray meets: the nearest surface, or all that dims a light.
//!
//! Distances are found first; normal and material follow for the nearest hit
//! alone. The common ray starts near and is answered by 32-bit distances. A
//! far hit, on something endless beyond all else, takes the cold path.

use crate::num::{Factor, Length, NEAR_LIMIT, Scaled, Unit};
use crate::observer::{Observer, RayKind};
use crate::prepared::{Light, Object, PreparedScene};
use crate::ray::{Point, Ray, Start};
use crate::shape::{Meeting, Path, Plane, Quadric, Shape, Sphere, StartSphere};
use crate::{Color, Vec3};

/// The nearest point of a ray on a surface.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit {
    /// The object's number.
    pub(crate) object: u16,
    pub(crate) point: Point,
    /// Of a sphereflake: the sphere, and its normal at the point.
    pub(crate) part: Option<(Path, Vec3<Unit>)>,
}

impl Hit {
    fn new(object: u16, point: Point) -> Self {
        Self {
            object,
            point,
            part: None,
        }
    }
}

/// The nearest of the near hits.
struct Nearest {
    object: u16,
    distance: Length,
    /// Of a sphereflake: where on it.
    meeting: Option<Meeting>,
}

impl Nearest {
    fn hit(&self, objects: &[Object], ray: &Ray) -> Hit {
        let part = self.meeting.as_ref().and_then(|meeting| {
            let object = objects.get(usize::from(self.object))?;
            let Shape::Sphereflake(flake) = &object.shape else {
                return None;
            };
            Some((meeting.path, flake.normal(meeting)))
        });
        Hit {
            object: self.object,
            point: ray.at(self.distance),
            part,
        }
    }
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
        match nearest_near(scene.objects, ray, |_| true) {
            Some(nearest) => Some(nearest.hit(scene.objects, ray)),
            None => nearest_far(scene.objects, ray),
        }
    } else {
        nearest_from_far(scene.objects, ray)
    }
}

/// Among hits less than [`NEAR_LIMIT`] away, from a near origin.
#[inline]
fn nearest_near(objects: &[Object], ray: &Ray, counts: impl Fn(&Shape) -> bool) -> Option<Nearest> {
    let origin = ray.origin.coordinates;
    let mut limit = NEAR_LIMIT;
    let mut nearest = None;
    for (object, item) in (0..).zip(objects) {
        if !counts(&item.shape) {
            continue;
        }
        let is_start = ray.start.object == object;
        let mut meeting = None;
        let distance = match &item.shape {
            Shape::Sphere(sphere) if is_start => ray
                .start
                .inward
                .then(|| sphere.across(origin, ray.direction)),
            Shape::Sphere(sphere) => sphere.distance(origin, ray.direction),
            Shape::Plane(_) if is_start => None,
            Shape::Plane(plane) => plane.distance(ray, limit),
            Shape::Quadric(quadric) => quadric
                .nearest(ray, is_start.then_some(ray.start.inward))
                .and_then(Scaled::near)
                .filter(|distance| is_start || *distance > Length::ZERO),
            Shape::Sphereflake(flake) => {
                meeting = flake.nearest(ray, part_of(&ray.start, is_start), limit);
                meeting.as_ref().map(Meeting::distance)
            }
        };
        if let Some(distance) = distance
            && distance < limit
        {
            limit = distance;
            nearest = Some(Nearest {
                object,
                distance,
                meeting,
            });
        }
    }
    nearest
}

/// The sphere of a flake that a ray starts on.
fn part_of(start: &Start, is_start: bool) -> Option<StartSphere> {
    is_start.then_some(StartSphere {
        path: start.part,
        inward: start.inward,
    })
}

/// Among endless surfaces, at any distance, from any origin.
#[cold]
fn nearest_far(objects: &[Object], ray: &Ray) -> Option<Hit> {
    let (object, distance) = nearest_endless(objects, ray)?;
    Some(Hit::new(object, ray.far_at(distance)))
}

fn nearest_endless(objects: &[Object], ray: &Ray) -> Option<(u16, Scaled)> {
    (0..)
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
            distance.map(|distance| (index, distance))
        })
        .min_by_key(|(_, distance)| *distance)
}

/// StartSphere a far origin, outside of all finite geometry.
///
/// The ray goes on as a near one from shortly before it may meet finite
/// geometry; endless surfaces are looked for from its true origin.
#[cold]
fn nearest_from_far(objects: &[Object], ray: &Ray) -> Option<Hit> {
    let endless = nearest_endless(objects, ray);
    let finite = ray.approaching().and_then(|(ray, skipped)| {
        let nearest = nearest_near(objects, &ray, Shape::is_finite)?;
        let distance = i64::from(nearest.distance.to_bits()) + skipped;
        Some((nearest.hit(objects, &ray), distance))
    });
    match (finite, endless) {
        (Some((hit, distance)), Some((_, endless))) if distance <= endless.to_bits() => Some(hit),
        (_, Some((object, distance))) => Some(Hit::new(object, ray.far_at(distance))),
        (finite, None) => finite.map(|(hit, _)| hit),
    }
}

/// The way from a light to a point of a surface.
///
/// Shadow rays are traced from the light: it is near, wherever the point is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowRay<'s> {
    pub(crate) light: &'s Light,
    /// StartSphere the light to the point.
    pub(crate) direction: Vec3<Unit>,
    /// To the point, if it is near; else the light's way passes all finite
    /// geometry.
    pub(crate) distance: Length,
    /// To the point, wherever it is, in steps of a [`Length`].
    pub(crate) reach: i64,
    pub(crate) point: Point,
    /// The surface that the point is on; `inward` if it is lit from its inside.
    pub(crate) start: Start,
}

impl ShadowRay<'_> {
    fn ray(&self) -> Ray {
        Ray {
            origin: Point::near(self.light.position),
            direction: self.direction,
            start: Start::NOWHERE,
        }
    }
}

/// What is left of a light: each surface on the way lets its `kt` through.
///
/// `None` if that is nothing.
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
            Shape::Quadric(quadric) => quadric_crossings(quadric, shadow, is_start),
            Shape::Sphereflake(flake) => {
                let ray = shadow.ray();
                let from = part_of(&shadow.start, is_start);
                flake.crossings(&ray, from, shadow.distance, &mut |distance| {
                    left = left.filtered(scene.transmitted(object, ray.at(distance)));
                    !left.is_black()
                });
                [None, None]
            }
        };
        for point in crossings.into_iter().flatten() {
            left = left.filtered(scene.transmitted(object, point));
        }
        if left.is_black() {
            observer.intersections(tested);
            return None;
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
    let ray = shadow.ray();
    let before = |distance: &Length| *distance > Length::ZERO && *distance < shadow.distance;
    // StartSphere the inside of a sphere the exit is the lit point itself.
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
    let ray = shadow.ray();
    let point = ray.far_at(plane.unbounded_distance(&ray)?);
    plane.covers(point).then_some(point)
}

/// Its own surface is looked for from the point, where one root is known.
fn quadric_crossings(
    quadric: &Quadric,
    shadow: &ShadowRay<'_>,
    is_start: bool,
) -> [Option<Point>; 2] {
    let (ray, start) = if is_start {
        let back = Ray {
            origin: shadow.point,
            direction: -shadow.direction,
            start: shadow.start,
        };
        (back, Some(shadow.start.inward))
    } else {
        (shadow.ray(), None)
    };
    quadric.crossings(&ray, start).map(|crossing| {
        crossing
            .filter(|distance| (1..shadow.reach).contains(&distance.to_bits()))
            .map(|distance| ray.far_at(distance))
    })
}
