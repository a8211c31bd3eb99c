use super::point::Point;
use super::ray::Ray;
use super::surface::OriginSurface;
use crate::math::{InverseLength, Length, SoftFloat, Unit, Vec3, normalize};

/// The segment from a light to a point of a surface.
///
/// Shadow rays are traced from the light, because a light is always in the near range (each
/// coordinate within ±3.5), while the point may be in the extended range.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShadowSegment<'r> {
    /// Position of the light.
    pub(crate) light: &'r Vec3<Length>,
    /// Vector from the point to the light, in units of `2^(shift - 28)`. Here, `shift` is that of
    /// the point.
    pub(crate) to_light: Vec3<Length>,
    /// Reciprocal length of `to_light`.
    pub(crate) inverse: InverseLength,
    /// The ray that hit the point. Its origin has been moved to the point, and its field `leaves`
    /// is the surface of the point.
    pub(crate) ray: &'r Ray,
}

impl ShadowSegment<'_> {
    /// Returns the unit vector from the point to the light.
    pub(crate) fn direction_to_light(&self) -> Vec3<Unit> {
        normalize(self.to_light.map(Length::to_bits), self.inverse)
    }

    /// Returns the length of the segment in units of `2^(shift - 28)`. Here, `shift` is that of the
    /// point.
    fn length(&self) -> Length {
        Length::from_bits(self.inverse.length() as i32)
    }

    /// Returns the length of the segment if the point is in the near range (each coordinate within
    /// ±3.5). For a point in the extended range, returns [`Length::MAX`], because the point is then
    /// beyond all bounded geometry.
    pub(crate) fn near_length(&self) -> Length {
        if self.ray.origin.is_near() {
            self.length()
        } else {
            Length::MAX
        }
    }

    /// Returns the length of the segment in units of 2^-28. The point may be in the near or the
    /// extended range.
    pub(crate) fn full_length(&self) -> i64 {
        i64::from(self.length().to_bits()) << self.ray.origin.shift
    }

    /// If `distance` is within the segment, calls `visit` with the point at that distance along
    /// `ray`. Returns false if `visit` asks to stop.
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
