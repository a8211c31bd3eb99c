use super::point::Point;
use super::ray::Ray;
use super::surface::OriginSurface;
use crate::math::{InverseLength, Length, SoftFloat, Unit, Vec3, normalize};

/// The segment from a light to a point of a surface.
///
/// Shadow rays are traced from the light, which is near wherever the point is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowSegment<'r> {
    /// Position of the light.
    pub(crate) light: &'r Vec3<Length>,
    /// Vector from the point to the light, in steps of the point's shift.
    pub(crate) to_light: Vec3<Length>,
    /// Reciprocal length of `to_light`.
    pub(crate) inverse: InverseLength,
    /// The ray that hit the point: its origin is the point, and it leaves the point's surface.
    pub(crate) ray: &'r Ray,
}

impl ShadowSegment<'_> {
    /// Unit vector from the point to the light.
    pub(crate) fn direction_to_light(&self) -> Vec3<Unit> {
        normalize(self.to_light.map(Length::to_bits), self.inverse)
    }

    /// Length in steps of the point's shift.
    fn length(&self) -> Length {
        Length::from_bits(self.inverse.length() as i32)
    }

    /// Length if the point is near, else [`Length::MAX`]: the segment then passes through
    /// all bounded geometry.
    pub(crate) fn near_length(&self) -> Length {
        if self.ray.origin.is_near() {
            self.length()
        } else {
            Length::MAX
        }
    }

    /// Length in steps of a [`Length`], wherever the point is.
    pub(crate) fn full_length(&self) -> i64 {
        i64::from(self.length().to_bits()) << self.ray.origin.shift
    }

    /// Visits the point of a ray at a distance if that is within the segment. Returns false
    /// if the visitor asks to stop.
    pub(crate) fn visit_at(
        &self,
        ray: &Ray,
        distance: SoftFloat,
        visit: &mut dyn FnMut(Point) -> bool,
    ) -> bool {
        let is_within = (1..self.full_length()).contains(&distance.to_bits());
        !is_within || visit(ray.at_extended(distance))
    }

    /// Returns the ray from the light to the point.
    #[inline(never)]
    pub(crate) fn to_ray(self) -> Ray {
        Ray {
            origin: Point::near(*self.light),
            direction: -self.direction_to_light(),
            leaves: OriginSurface::NONE,
        }
    }
}
