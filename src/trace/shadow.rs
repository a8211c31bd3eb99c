//! What is left of a light on its way to a surface.
//!
//! The common case is an opaque sphere or plane, or none: whether it is in the
//! way is known without a root and without the point where it is met. Only
//! what lets light through, or is of a rarer shape, is looked at more closely.

use crate::geometry::{
    OriginSurface, Plane, Point, Quadric, Ray, Shape, Sphere, SurfaceFlags, Texture, narrowed,
};
use crate::math::outlined::to_bits;
use crate::math::{Color, Factor, InverseLength, Length, SoftFloat, Unit, Vec3, Weight, normalize};
use crate::observer::{Observer, RayKind, ShapeKind};
use crate::prepare::{Light, Object, PreparedScene};

/// The way from a light to a point of a surface.
///
/// Shadow rays are traced from the light: it is near, wherever the point is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowRay<'s> {
    pub(crate) light: &'s Light,
    /// From the point to the light, in steps of the point's shift.
    pub(crate) way: Vec3<Length>,
    /// The reciprocal of how long that is.
    pub(crate) inverse: InverseLength,
    /// The ray that has met the point.
    pub(crate) ray: &'s Ray,
}

impl ShadowRay<'_> {
    /// Whether light number `index` arrives, and in `left` what the surfaces on
    /// its way leave of it; `None` if that is all.
    #[inline(always)]
    pub(crate) fn arrives(
        self,
        scene: &PreparedScene<'_>,
        index: usize,
        left: &mut Option<Color<Factor>>,
        observer: &mut impl Observer,
    ) -> bool {
        observer.ray(RayKind::Shadow);
        let start = &self.ray.start;
        if start.nature.is(self.light.in_view) && !start.inward {
            return true;
        }
        let own = self.ray.start.left;
        let direction = narrowed(self.way.map(Length::to_bits), self.inverse);
        for sight in scene.sights.by_light(index).unwrap_or_default() {
            if sight.may_meet(direction)
                && sight.object != own
                && !self.passes(scene, sight.object, left, observer)
            {
                return false;
            }
        }
        if self.ray.start.nature.is(SurfaceFlags::FINITE)
            && !self.light.is_walled
            && self.ray.origin.is_near()
        {
            return true;
        }
        let mut endless = scene.endless.iter().filter(|&&object| object != own);
        endless.all(|&object| self.passes(scene, object, left, observer))
    }

    /// Takes what an object that may be in the way takes of the light; false if
    /// nothing is left.
    #[inline(never)]
    fn passes(
        self,
        scene: &PreparedScene<'_>,
        number: u16,
        left: &mut Option<Color<Factor>>,
        observer: &mut impl Observer,
    ) -> bool {
        let object = scene.object(number);
        let is_start = number == self.ray.start.object;
        // What each crossing takes, if that is the same everywhere.
        let kt = match object.texture {
            Texture::Uniform(material) => Some(scene.material(material).kt),
            Texture::Checker(_) => None,
        };
        let is_opaque = kt.is_some_and(Color::<Weight>::is_black);
        let crossings = self.crossings(object, is_start, is_opaque, observer);
        if crossings == Some(0) {
            observer.test(object.shape.kind(), false);
            return true;
        }
        if crossings.is_some() && is_opaque {
            observer.test(object.shape.kind(), true);
            return false;
        }
        // A board: whether it reaches to where it is crossed is not known yet.
        if is_opaque && let Shape::Plane(plane) = &object.shape {
            let is_crossed = self.of_plane(plane).is_some();
            observer.test(ShapeKind::Plane, is_crossed);
            return !is_crossed;
        }
        let before = left.unwrap_or(Color::WHITE);
        let rest = match (crossings, kt) {
            (Some(crossings), Some(kt)) => {
                let kt = kt.narrowed();
                (0..crossings).fold(before, |left, _| left.filtered(kt))
            }
            _ => filtered(scene, &self, object, is_start, before, observer),
        };
        observer.test(object.shape.kind(), rest != before);
        *left = Some(rest);
        !rest.is_black()
    }

    /// How often the light meets an object, if that can be told for sure
    /// without a root.
    #[inline(always)]
    fn crossings(
        &self,
        object: &Object,
        is_start: bool,
        is_opaque: bool,
        observer: &mut impl Observer,
    ) -> Option<u8> {
        let light = self.light.position;
        match &object.shape {
            Shape::Sphere(sphere) => {
                let [entry, exit] = sphere.is_crossed(light, -self.direction(), self.distance());
                // From the inside of a sphere the exit is the lit point itself.
                Some(u8::from(entry) + u8::from(exit && !is_start))
            }
            Shape::Plane(plane) => {
                let is_between = plane.is_between(light, self.ray.origin, self.ray.direction);
                (!is_between || plane.bounds.is_none()).then_some(is_between.into())
            }
            Shape::Sphereflake(flake) if is_opaque => {
                let from = is_start.then_some(self.ray.start);
                let reach = self.distance();
                Some(flake.is_between(&self.beam(), from, reach, observer).into())
            }
            Shape::Quadric(_) | Shape::Sphereflake(_) => None,
        }
    }

    /// From the point to the light.
    #[inline]
    fn direction(&self) -> Vec3<Unit> {
        normalize(self.way.map(Length::to_bits), self.inverse)
    }

    /// To the point, in steps of the point's shift.
    #[inline]
    fn length(&self) -> Length {
        Length::from_bits(self.inverse.length() as i32)
    }

    /// To the point, if it is near; else the light's way passes all finite
    /// geometry.
    fn distance(&self) -> Length {
        if self.ray.origin.is_near() {
            self.length()
        } else {
            Length::MAX
        }
    }

    /// To the point, wherever it is, in steps of a [`Length`].
    fn reach(&self) -> i64 {
        i64::from(self.length().to_bits()) << self.ray.origin.shift
    }

    #[inline(never)]
    fn beam(&self) -> Ray {
        Ray {
            origin: Point::near(self.light.position),
            direction: -self.direction(),
            start: OriginSurface::NOWHERE,
        }
    }
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
    let mut pass = |point| {
        left = left.filtered(scene.transmitted(object, point));
        !left.is_black()
    };
    let mut ray = shadow.beam();
    let crossings = match &object.shape {
        Shape::Sphere(sphere) => shadow.of_sphere(sphere, &ray, is_start),
        Shape::Quadric(quadric) => shadow.of_quadric(quadric, &mut ray, is_start),
        Shape::Plane(plane) => {
            if let Some(point) = shadow.of_plane(plane) {
                pass(point);
            }
            return left;
        }
        Shape::Sphereflake(flake) => {
            let from = is_start.then_some(shadow.ray.start);
            flake.crossings(&ray, from, shadow.distance(), observer, &mut |distance| {
                pass(ray.at(distance))
            });
            return left;
        }
    };
    for distance in crossings.iter().flatten() {
        if (1..shadow.reach()).contains(&to_bits(*distance)) {
            pass(ray.far_at(*distance));
        }
    }
    left
}

/// Where a ray crosses an object.
type Crossings = [Option<SoftFloat>; 2];

impl ShadowRay<'_> {
    fn of_sphere(&self, sphere: &Sphere, ray: &Ray, is_start: bool) -> Crossings {
        let [entry, exit] = sphere.crossings(self.light.position, ray.direction);
        // From the inside of a sphere the exit is the lit point itself.
        let exit = exit.filter(|_| !is_start);
        let ahead = |it: Option<Length>| it.filter(|distance| *distance > Length::ZERO);
        [ahead(entry), ahead(exit)].map(|it| it.map(SoftFloat::unordered))
    }

    /// Its own surface is looked for from the point, where one root is known.
    fn of_quadric(&self, quadric: &Quadric, ray: &mut Ray, is_start: bool) -> Crossings {
        if is_start {
            *ray = Ray {
                origin: self.ray.origin,
                direction: -ray.direction,
                start: self.ray.start,
            };
        }
        quadric.crossings(ray, is_start.then_some(self.ray.start.inward))
    }

    /// Of a plane that is between the light and the point.
    #[inline(never)]
    fn of_plane(&self, plane: &Plane) -> Option<Point> {
        let (light, point) = (self.light.position, self.ray.origin);
        let sides = [Point::near(light), point].map(|side| plane.depth(side));
        let crossing = if point.is_near() {
            Point::near(plane.crossing(light, -self.way, sides))
        } else if Plane::may_hold(sides[1]) {
            point
        } else {
            let ray = self.beam();
            ray.far_at(plane.unbounded_distance(&ray)?)
        };
        plane.covers(&crossing).then_some(crossing)
    }
}
