use crate::geometry::{BoundingSphere, SurfaceFlags};
use crate::math::{Length, Product, Square, Vec3, square_root};
use crate::prepare::{Light, Object};

/// For each light, marks the spheres that no other object can hide from the light. A point of a
/// marked sphere needs no shadow ray if it faces the light.
pub(in crate::prepare) fn mark_unoccluded(lights: &mut [Light], objects: &mut [Object]) {
    for (light, index) in lights.iter_mut().zip(0..) {
        light.unoccluded = SurfaceFlags::unoccluded_from(index);
        for index in 0..objects.len() {
            let is_unoccluded = is_unoccluded(light.position, objects, index);
            if let Some(object) = objects.get_mut(index) {
                object.flags = object.flags.with(light.unoccluded, is_unoccluded);
            }
        }
    }
}

/// Returns true if the object at `index` is a sphere that no other object can hide from the
/// light.
fn is_unoccluded(light: Vec3<Length>, objects: &[Object], index: usize) -> bool {
    let sphere = objects
        .get(index)
        .filter(|object| object.shape.is_sphere())
        .and_then(|object| object.shape.bounding_sphere());
    let Some(sphere) = sphere else {
        return false;
    };
    let Some(silhouette) = Silhouette::new(light, &sphere) else {
        return false;
    };
    let mut others = objects
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != index);
    others.all(|(_, other)| match other.shape.bounding_sphere() {
        Some(other) => {
            Silhouette::new(light, &other).is_some_and(|it| !it.may_occlude(&silhouette))
        }
        None => !other.shape.may_separate(light, &sphere),
    })
}

/// A bounding sphere as seen from a point outside it.
struct Silhouette {
    to_center: Vec3<Length>,
    radius: Length,
    /// Length of the tangents from the point to the sphere. No part of the sphere that is
    /// visible from the point is farther away than this length.
    tangent: Length,
}

impl Silhouette {
    /// Returns `None` if the point is inside the sphere.
    fn new(point: Vec3<Length>, bound: &BoundingSphere) -> Option<Self> {
        let to_center = bound.center - point;
        let squared = to_center.squared() - bound.radius.square();
        // The squared length of the tangent has Q56, so the length has Q28.
        let tangent = || Length::from_bits(square_root(squared.to_bits() as u64) as i32);
        (squared > 0).then(|| Self {
            to_center,
            radius: bound.radius,
            tangent: tangent(),
        })
    }

    /// Returns true if this sphere may cast a shadow on the side of `sphere` that faces the
    /// light.
    ///
    /// Seen from the light, each sphere fills a cone. The half angles of the two cones are `a`
    /// and `b`. The cones do not overlap if the angle between their axes is above `a + b`. The
    /// code compares the cosine of the angle between the axes with `cos(a + b) = cos a cos b -
    /// sin a sin b`. To avoid a division, both sides are multiplied by the distances of the two
    /// centers from the light.
    fn may_occlude(&self, sphere: &Self) -> bool {
        /// Margin that exceeds the sum of all rounding errors.
        const MARGIN: Length = Length::lit("0.00001");
        let between = self.to_center.dot(sphere.to_center);
        let sum = self.tangent.product(sphere.tangent) - self.radius.product(sphere.radius);
        let is_aside = between + MARGIN.product(Length::ONE) < sum;
        let beyond = sphere.tangent + self.radius + MARGIN;
        let is_behind = self.to_center.squared() > beyond.square();
        !is_aside && !is_behind
    }
}
