//! What is known of a scene's objects before any ray is traced.
//!
//! All eye rays start from one point, all shadow rays of a light from another,
//! and most rays pass most objects by: what tells so is computed once.

use heapless::VecView;

use crate::Vec3;
use crate::num::Length;
use crate::prepared::{Camera, Light, Object};
use crate::ray::Point;
use crate::shape::{Around, Bound, Shape, Sight};
use crate::vector::round_length;

/// The lists that tell where to look for objects, each as long as theirs.
pub(crate) struct Index<'b> {
    pub(crate) finite: &'b mut VecView<Around>,
    pub(crate) endless: &'b mut VecView<u16>,
    pub(crate) eye: &'b mut VecView<Bound>,
}

impl Index<'_> {
    /// Lists all objects.
    pub(crate) fn fill(self, objects: &[Object], camera: &Camera) {
        self.finite.clear();
        self.endless.clear();
        self.eye.clear();
        // There is room in each list.
        for (object, number) in objects.iter().zip(0..) {
            let Some(bound) = object.shape.bounding_sphere() else {
                let _ = self.endless.push(number);
                continue;
            };
            let _ = self.finite.push(bound.around(number));
            let _ = self.eye.push(in_view(&bound, camera));
        }
    }
}

/// A bound in the camera's frame, to the right, up and forward of the eye, and
/// larger by more than what is rounded when its outline is computed.
fn in_view(bound: &Bound, camera: &Camera) -> Bound {
    const MARGIN: Length = Length::lit("0.00001");
    let to_center = bound.center - camera.eye;
    let along = |axis| round_length(to_center.along(axis).to_bits(), 30);
    Bound {
        center: Vec3::new(along(camera.right), along(camera.up), along(camera.forward)),
        radius: bound.radius + (bound.radius >> 10) + MARGIN,
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
        .filter_map(|object| object.shape.bounding_sphere());
    let mut is_walled = false;
    for (bound, sight) in bounds.zip(sights) {
        *sight = bound.seen_from(light.position);
        is_walled |= endless.iter().any(|number| parts(number, &bound));
    }
    light.is_walled = is_walled;
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
