//! What is known of a scene's objects before any ray is traced.
//!
//! All shadow rays of a light start from one point, and most rays pass most
//! objects by: what tells so is computed once. (What the eye sees is found line
//! by line, so that the camera may move.)

use heapless::VecView;

use crate::Vec3;
use crate::num::{Length, Square};
use crate::prepared::{Light, Material, Object};
use crate::ray::{Nature, Point};
use crate::shape::{Around, Bound, Shape, Sight};
use crate::texture::Texture;

/// The lists that tell where to look for objects, each as long as theirs.
pub(crate) struct Index<'b> {
    pub(crate) finite: &'b mut VecView<Around>,
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
    }
}

/// What a light sees of the finite objects, and whether something endless may
/// be between it and one of them.
pub(crate) fn look(light: &mut Light, objects: &[Object], endless: &[u16], sights: &mut [Sight]) {
    let parts = |number: &u16, bound: &Bound| {
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
            object.nature = object.nature.and(Nature::ALONE, is_alone);
        }
    }
}

/// Whether a shape does not reach into a bound.
fn is_clear_of(shape: &Shape, bound: &Bound) -> bool {
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
fn may_part(endless: &Shape, point: Vec3<Length>, bound: &Bound) -> bool {
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
    use super::*;
    use crate::Color;
    use crate::num::{Unit, Weight};
    use crate::shape::{Plane, Sphere};

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

    /// Which objects are alone.
    fn alone<const N: usize>(mut objects: [Object; N]) -> [bool; N] {
        let glass = Material {
            kt: Color::new(Weight::ZERO, Weight::ZERO, Weight::DELTA),
            ..Material::default()
        };
        seclude(&mut objects, &[Material::default(), glass]);
        objects.map(|object| object.nature.is(Nature::ALONE))
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
}
