//! What is left of a light on its way to a surface.
//!
//! The common case is an opaque sphere or plane, or none: whether it is in the
//! way is known without a root and without the point where it is met. Only
//! what lets light through, or is of a rarer shape, is looked at more closely.

use crate::num::{Factor, Length, Unit};
use crate::observer::Observer;
use crate::prepared::{Light, Object, PreparedScene};
use crate::ray::{Point, Ray, Start};
use crate::shape::{Plane, Quadric, Shape, Sphere};
use crate::texture::Texture;
use crate::vector::round_length;
use crate::{Color, Vec3};

/// The way from a light to a point of a surface.
///
/// Shadow rays are traced from the light: it is near, wherever the point is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowRay<'s> {
    pub(crate) light: &'s Light,
    /// From the point to the light.
    pub(crate) to_light: Vec3<Unit>,
    pub(crate) point: &'s Point,
    /// From where the point is seen, towards it.
    pub(crate) view: &'s Vec3<Unit>,
    /// The surface that the point is on; `inward` if it is lit from its inside.
    pub(crate) start: &'s Start,
}

impl ShadowRay<'_> {
    /// To the point, in steps of the point's shift.
    fn length(&self) -> Length {
        let way = self.point.to(self.light.position);
        round_length(way.along(self.to_light).to_bits(), 30)
    }

    /// To the point, if it is near; else the light's way passes all finite
    /// geometry.
    fn distance(&self) -> Length {
        if self.point.is_near() {
            self.length()
        } else {
            Length::MAX
        }
    }

    /// To the point, wherever it is, in steps of a [`Length`].
    fn reach(&self) -> i64 {
        i64::from(self.length().to_bits()) << self.point.shift
    }

    fn ray(&self) -> Ray {
        Ray {
            origin: Point::near(self.light.position),
            direction: -self.to_light,
            start: Start::NOWHERE,
        }
    }
}

impl ShadowRay<'_> {
    /// Takes what an object that may be in the way takes of the light; false if
    /// nothing is left.
    #[inline(never)]
    pub(crate) fn passes(
        &self,
        scene: &PreparedScene<'_>,
        number: u16,
        left: &mut Option<Color<Factor>>,
        observer: &mut impl Observer,
    ) -> bool {
        let object = scene.object(number);
        let is_start = number == self.start.object;
        let light = self.light.position;
        // How often the light meets the surface, if that is known for sure.
        let crossings = match &object.shape {
            Shape::Sphere(sphere) => {
                let [entry, exit] = sphere.is_crossed(light, -self.to_light, self.distance());
                // From the inside of a sphere the exit is the lit point itself.
                Some(u8::from(entry) + u8::from(exit && !is_start))
            }
            Shape::Plane(plane) => {
                let is_between = plane.is_between(light, *self.point, *self.view);
                (!is_between || plane.bounds.is_none()).then_some(is_between.into())
            }
            Shape::Sphereflake(flake) if is_opaque(scene, object) => {
                let from = is_start.then_some(*self.start);
                let reach = self.distance();
                Some(flake.is_between(&self.ray(), from, reach, observer).into())
            }
            Shape::Quadric(_) | Shape::Sphereflake(_) => None,
        };
        let before = left.unwrap_or(Color::WHITE);
        let rest = match (crossings, &object.texture) {
            (Some(0), _) => {
                observer.test(object.shape.kind(), false);
                return true;
            }
            (Some(crossings), Texture::Uniform(material)) => {
                let kt = scene.material(*material).kt;
                if kt.is_black() {
                    observer.test(object.shape.kind(), true);
                    return false;
                }
                (0..crossings).fold(before, |left, _| left.filtered(kt))
            }
            _ => filtered(scene, self, object, is_start, before, observer),
        };
        observer.test(object.shape.kind(), rest != before);
        *left = Some(rest);
        !rest.is_black()
    }
}

/// Whether an object lets no light through anywhere.
fn is_opaque(scene: &PreparedScene<'_>, object: &Object) -> bool {
    matches!(object.texture, Texture::Uniform(material) if scene.material(material).kt.is_black())
}

/// What is left of the light behind an object that may be in the way.
#[inline(never)]
fn filtered(
    scene: &PreparedScene<'_>,
    shadow: &ShadowRay<'_>,
    object: &Object,
    is_start: bool,
    mut left: Color<Factor>,
    observer: &mut impl Observer,
) -> Color<Factor> {
    let crossings = match &object.shape {
        Shape::Sphere(sphere) => sphere_crossings(sphere, shadow, is_start),
        Shape::Plane(plane) => [plane_crossing(plane, shadow), None],
        Shape::Quadric(quadric) => quadric_crossings(quadric, shadow, is_start),
        Shape::Sphereflake(flake) => {
            let ray = shadow.ray();
            let from = is_start.then_some(*shadow.start);
            flake.crossings(&ray, from, shadow.distance(), observer, &mut |distance| {
                left = left.filtered(scene.transmitted(object, ray.at(distance)));
                !left.is_black()
            });
            [None, None]
        }
    };
    for point in crossings.into_iter().flatten() {
        left = left.filtered(scene.transmitted(object, point));
    }
    left
}

fn sphere_crossings(sphere: &Sphere, shadow: &ShadowRay<'_>, is_start: bool) -> [Option<Point>; 2] {
    let ray = shadow.ray();
    let [entry, exit] = sphere.crossings(shadow.light.position, ray.direction);
    let before = |distance: &Length| *distance > Length::ZERO && *distance < shadow.distance();
    // From the inside of a sphere the exit is the lit point itself.
    let exit = if is_start { None } else { exit };
    [entry, exit].map(|crossing| crossing.filter(before).map(|distance| ray.at(distance)))
}

fn plane_crossing(plane: &Plane, shadow: &ShadowRay<'_>) -> Option<Point> {
    let point = if plane.may_hold(*shadow.point) {
        *shadow.point
    } else {
        let ray = shadow.ray();
        ray.far_at(plane.unbounded_distance(&ray)?)
    };
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
            origin: *shadow.point,
            direction: shadow.to_light,
            start: *shadow.start,
        };
        (back, Some(shadow.start.inward))
    } else {
        (shadow.ray(), None)
    };
    quadric.crossings(&ray, start).map(|crossing| {
        crossing
            .filter(|distance| (1..shadow.reach()).contains(&distance.to_bits()))
            .map(|distance| ray.far_at(distance))
    })
}
