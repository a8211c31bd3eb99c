//! What is known of a scene's objects before any ray is traced.
//!
//! All shadow rays of a light start from one point, and most rays pass most
//! objects by: what tells so is computed once. (What the eye sees is found line
//! by line, so that the camera may move.)

use core::mem;

use heapless::VecView;

use crate::geometry::{BoundingSphere, CullSphere, LightCone, Point, Shape, SurfaceFlags, Texture};
use crate::math::{Length, Product, Square, Vec3, square_root};
use crate::prepare::{Light, Material, Object};

/// How many objects that are near each other share a bound.
pub(crate) const GROUP: usize = 8;

/// Up to so many objects are looked at one by one, as so few do not repay groups.
pub(crate) const FEW: usize = 2 * GROUP;

/// The lists that tell where to look for objects, each as long as theirs.
pub(crate) struct Index<'b> {
    pub(crate) finite: &'b mut VecView<CullSphere>,
    pub(crate) groups: &'b mut VecView<CullSphere>,
    pub(crate) endless: &'b mut VecView<u16>,
}

impl Index<'_> {
    /// Lists all objects.
    pub(crate) fn fill(self, objects: &[Object]) {
        self.finite.clear();
        self.endless.clear();
        // There is room in each list.
        for (object, number) in objects.iter().zip(0..) {
            let Some(bound) = object.shape.bounding_sphere() else {
                let _ = self.endless.push(number);
                continue;
            };
            let _ = self.finite.push(bound.around(number));
        }
        if self.finite.len() > FEW {
            gather(self.finite);
        }
        self.groups.clear();
        for group in self.finite.chunks(GROUP) {
            let _ = self.groups.push(CullSphere::all(group));
        }
    }
}

/// Brings neighbors together: after the first of each group, what is nearest to that.
fn gather(mut objects: &mut [CullSphere]) {
    let Some(mut first) = objects.first().copied() else {
        return;
    };
    for number in 0.. {
        let Some((next, rest)) = mem::take(&mut objects).split_first_mut() else {
            return;
        };
        if number % GROUP == 0 {
            first = *next;
        }
        for other in rest.iter_mut() {
            if first.squared_to(other) < first.squared_to(next) {
                mem::swap(next, other);
            }
        }
        objects = rest;
    }
}

/// What a light sees of the finite objects, and whether something endless may
/// be between it and one of them.
pub(crate) fn look(
    light: &mut Light,
    objects: &[Object],
    endless: &[u16],
    sights: &mut [LightCone],
) {
    let parts = |number: &u16, bound: &BoundingSphere| {
        let object = objects.get(usize::from(*number));
        object.is_some_and(|object| may_part(&object.shape, light.position, bound))
    };
    let bounds = objects
        .iter()
        .zip(0..)
        .filter_map(|(object, number)| Some((object.shape.bounding_sphere()?, number)));
    let mut is_walled = false;
    for ((bound, number), sight) in bounds.zip(sights) {
        *sight = bound.seen_from(light.position, number);
        is_walled |= endless.iter().any(|number| parts(number, &bound));
    }
    light.is_walled = is_walled;
}

/// Marks the spheres whose side that faces a light nothing can hide.
pub(crate) fn unveil(light: &Light, objects: &mut [Object]) {
    let position = light.position;
    for index in 0..objects.len() {
        let Some(Shape::Sphere(sphere)) = objects.get(index).map(|object| &object.shape) else {
            continue;
        };
        let bound = sphere.bounding_sphere();
        let Some(outline) = Outline::new(position, &bound) else {
            continue;
        };
        let mut others = objects
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index);
        let is_in_view = others.all(|(_, other)| match other.shape.bounding_sphere() {
            Some(other) => Outline::new(position, &other).is_some_and(|it| !it.may_hide(&outline)),
            None => !may_part(&other.shape, position, &bound),
        });
        if let Some(object) = objects.get_mut(index) {
            object.nature = object.nature.and(light.in_view, is_in_view);
        }
    }
}

/// A bound as a point outside of it sees it.
struct Outline {
    to_center: Vec3<Length>,
    radius: Length,
    /// From the point to where lines touch the bound: what faces it is no farther away.
    tangent: Length,
}

impl Outline {
    /// `None` from within.
    fn new(point: Vec3<Length>, bound: &BoundingSphere) -> Option<Self> {
        let to_center = bound.center - point;
        let squared = to_center.squared() - bound.radius.square();
        // Q56 -> Q28
        let tangent = || Length::from_bits(square_root(squared.to_bits() as u64) as i32);
        (squared > 0).then(|| Self {
            to_center,
            radius: bound.radius,
            tangent: tangent(),
        })
    }

    /// Whether it may be in front of what of a sphere faces the point.
    fn may_hide(&self, sphere: &Self) -> bool {
        /// More than all roundings.
        const MARGIN: Length = Length::lit("0.00001");
        // The cosine of the angle between both next to `cos(a + b)` of half of what each
        // fills: multiplied by both distances.
        let between = self.to_center.dot(sphere.to_center);
        let together = self.tangent.product(sphere.tangent) - self.radius.product(sphere.radius);
        let is_aside = between + MARGIN.product(Length::ONE) < together;
        let beyond = sphere.tangent + self.radius + MARGIN;
        let is_behind = self.to_center.squared() > beyond.square();
        !is_aside && !is_behind
    }
}

/// Notes which spheres of glass nothing else reaches into: rays inside of them need look
/// for nothing else.
pub(crate) fn seclude(objects: &mut [Object], materials: &[Material]) {
    let is_clear = |number: u16| {
        let material = materials.get(usize::from(number));
        material.is_some_and(|material| !material.kt.is_black())
    };
    let is_glass = |object: &&Object| match &object.texture {
        Texture::Uniform(material) => is_clear(*material),
        Texture::Checker(checker) => checker.materials.into_iter().any(is_clear),
    };
    for number in 0..objects.len() {
        let Some(Object {
            shape: Shape::Sphere(sphere),
            ..
        }) = objects.get(number).filter(is_glass)
        else {
            continue;
        };
        let bound = sphere.bounding_sphere();
        let mut others = objects
            .iter()
            .zip(0..)
            .filter(|(_, other)| *other != number);
        let is_alone = others.all(|(other, _)| is_clear_of(&other.shape, &bound));
        if let Some(object) = objects.get_mut(number) {
            object.nature = object.nature.and(SurfaceFlags::ALONE, is_alone);
        }
    }
}

/// Whether a shape does not reach into a bound.
fn is_clear_of(shape: &Shape, bound: &BoundingSphere) -> bool {
    /// More than all roundings.
    const MARGIN: Length = Length::lit("0.00001");
    let radius = bound.radius + MARGIN;
    match (shape, shape.bounding_sphere()) {
        (_, Some(other)) => {
            (other.center - bound.center).squared() > (other.radius + radius).square()
        }
        (Shape::Plane(plane), None) => {
            plane.depth(Point::near(bound.center)).abs() > i64::from(radius.to_bits())
        }
        _ => false,
    }
}

/// Whether something endless may be between a point and something finite.
fn may_part(endless: &Shape, point: Vec3<Length>, bound: &BoundingSphere) -> bool {
    match endless {
        Shape::Plane(plane) => {
            let (from, to) = (
                plane.depth(Point::near(point)),
                plane.depth(Point::near(bound.center)),
            );
            from.signum() != to.signum() || to.abs() < i64::from(bound.radius.to_bits())
        }
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use fastrand::Rng;
    use heapless::Vec;

    use super::*;
    use crate::geometry::{Plane, Sphere};
    use crate::math::{Color, Unit, Weight};

    const OPAQUE: u16 = 0;
    const GLASS: u16 = 1;

    fn sphere(x: f64, material: u16) -> Object {
        let center = Vec3::new(Length::from_num(x), Length::ZERO, Length::ZERO);
        let sphere = Sphere::new(center, Length::lit("0.25"));
        Object::new(Shape::Sphere(sphere), Texture::Uniform(material))
    }

    fn floor(y: f64) -> Object {
        let up = Vec3::new(Unit::ZERO, Unit::ONE, Unit::ZERO);
        let offset = Length::from_num(y).to_bits().into();
        let plane = Shape::Plane(Plane::new(up, offset, None));
        Object::new(plane, Texture::Uniform(OPAQUE))
    }

    #[test]
    fn neighbors_are_in_a_group() {
        // Three clusters, taken in turns.
        let mut objects = [(); 3 * GROUP].map(|()| sphere(0.0, OPAQUE));
        for (number, object) in objects.iter_mut().enumerate() {
            let cluster = (number % 3) as f64 - 1.0;
            *object = sphere(0.9 * cluster + 0.01 * (number / 3) as f64, OPAQUE);
        }
        let (mut finite, mut groups) = (Vec::<_, 32>::new(), Vec::<_, 32>::new());
        let index = Index {
            finite: &mut finite,
            groups: &mut groups,
            endless: &mut Vec::<_, 32>::new(),
        };
        index.fill(&objects);
        assert_eq!(groups.len(), 3);
        let mut seen = [false; 3 * GROUP];
        for group in finite.chunks(GROUP) {
            let cluster = group[0].object % 3;
            for around in group {
                assert_eq!(around.object % 3, cluster);
                seen[usize::from(around.object)] = true;
            }
        }
        assert!(seen.into_iter().all(|seen| seen));
    }

    /// Which objects are alone.
    fn alone<const N: usize>(mut objects: [Object; N]) -> [bool; N] {
        let glass = Material {
            kt: Color::new(Weight::ZERO, Weight::ZERO, Weight::DELTA),
            ..Material::default()
        };
        seclude(&mut objects, &[Material::default(), glass]);
        objects.map(|object| object.nature.is(SurfaceFlags::ALONE))
    }

    #[test]
    fn glass_is_alone_where_nothing_reaches_into_it() {
        let (left, right) = (sphere(-0.25, GLASS), sphere(0.251, GLASS));
        assert_eq!(alone([left, right, floor(0.251)]), [true, true, false]);
        // Touching, one within the other, cut, and opaque.
        assert_eq!(alone([left, sphere(0.25, GLASS)]), [false, false]);
        assert_eq!(alone([left, sphere(-0.25, OPAQUE)]), [false, false]);
        assert_eq!(alone([left, floor(0.25)]), [false, false]);
        assert_eq!(alone([left, floor(-0.1)]), [false, false]);
        assert_eq!(alone([sphere(0.0, OPAQUE)]), [false]);
    }

    /// Which objects a light at some x has in view.
    fn in_view<const N: usize>(mut objects: [Object; N], x: f64) -> [bool; N] {
        let light = Light {
            position: Vec3::new(Length::from_num(x), Length::ZERO, Length::ZERO),
            in_view: SurfaceFlags::in_view(3),
            ..Light::default()
        };
        unveil(&light, &mut objects);
        objects.map(|object| object.nature.is(light.in_view))
    }

    #[test]
    fn nothing_hides_what_is_before_all_else() {
        let (left, right) = (sphere(-0.5, OPAQUE), sphere(0.5, OPAQUE));
        assert_eq!(
            in_view([left, right, floor(-0.5)], -1.0),
            [true, false, false]
        );
        assert_eq!(in_view([left, right], 0.0), [true, true]);
        // Between, within, and touched by something endless.
        assert_eq!(in_view([left, right], -0.5), [false, false]);
        assert_eq!(in_view([left, floor(0.125)], 1.0), [false, false]);
        assert_eq!(in_view([left, floor(-0.26)], 1.0), [true, false]);
        assert!(!SurfaceFlags::in_view(8).is(SurfaceFlags::in_view(7)));
    }

    /// What of a sphere in view faces the light is seen from there, by exact arithmetic.
    #[test]
    fn what_is_in_view_is_lit() {
        let random = &mut Rng::with_seed(1);
        let (mut points, mut hidden) = (0, 0);
        for _ in 0..if cfg!(miri) { 30 } else { 3000 } {
            let mut c = |reach: f64| Length::from_num((2.0 * random.f64() - 1.0) * reach);
            let light = Light {
                position: Vec3::new(c(1.0), c(1.0), c(1.0)),
                in_view: SurfaceFlags::in_view(0),
                ..Light::default()
            };
            let mut spheres = [(); 5].map(|()| {
                let center = Vec3::new(c(0.8), c(0.8), c(0.8));
                let sphere = Sphere::new(center, c(0.3).abs() + Length::lit("0.001"));
                Object::new(Shape::Sphere(sphere), Texture::Uniform(OPAQUE))
            });
            unveil(&light, &mut spheres);
            for (number, object) in spheres.iter().enumerate() {
                let Some(bound) = object.shape.bounding_sphere() else {
                    continue;
                };
                let [l, b] = [light.position, bound.center].map(exact);
                let radius: f64 = bound.radius.to_num();
                for _ in 0..30 {
                    let v = [(); 3].map(|()| random.f64() - 0.5);
                    let length = dot(v, v).sqrt();
                    let n = v.map(|c| c / length);
                    let point = [0, 1, 2].map(|i| b[i] + n[i] * radius);
                    let way = [0, 1, 2].map(|i| point[i] - l[i]);
                    if dot(way, n) > 0.0 {
                        continue;
                    }
                    let others = spheres
                        .iter()
                        .enumerate()
                        .filter(|(other, _)| *other != number);
                    let is_hidden = others
                        .filter_map(|(_, other)| other.shape.bounding_sphere())
                        .any(|other| is_between(l, way, &other));
                    let is_in_view = object.nature.is(light.in_view);
                    assert!(!is_in_view || !is_hidden, "{light:?} {spheres:?}");
                    points += i32::from(is_in_view);
                    hidden += i32::from(is_hidden);
                }
            }
        }
        assert!(
            points > 100 && hidden > 100,
            "{points} in view, {hidden} hidden"
        );
    }

    fn exact(v: Vec3<Length>) -> [f64; 3] {
        [v.x, v.y, v.z].map(|c| c.to_num())
    }

    fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    /// Whether a sphere is on the way from a point.
    fn is_between(from: [f64; 3], way: [f64; 3], sphere: &BoundingSphere) -> bool {
        let center = exact(sphere.center);
        let to_center = [0, 1, 2].map(|i| center[i] - from[i]);
        let share = (dot(to_center, way) / dot(way, way)).clamp(0.0, 1.0);
        let off = [0, 1, 2].map(|i| to_center[i] - share * way[i]);
        dot(off, off).sqrt() < sphere.radius.to_num::<f64>()
    }
}
