use super::intersect::Hit;
use crate::geometry::{OriginSurface, PrimitivePart, Ray, SurfaceFlags, SurfacePoint, are_near};
use crate::math::{SoftFloat, Unit, Vec3};
use crate::prepare::{Material, PreparedScene};

/// A ray with all data about its hit that shading needs.
///
/// The point, normal, side and material of a hit are computed only in this file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interaction<'s> {
    /// The ray that causes the interaction. After the ray has hit a surface, its origin is the hit
    /// point. The origin is on the side of the surface that the ray came from.
    pub(super) ray: Ray,
    /// Shading normal at the hit point. It points to the side that the ray comes from.
    pub(super) normal: Vec3<Unit>,
    /// Cosine of the angle of incidence. It is `-V · n`, where V is the direction of the ray and n
    /// is the normal. The cosine is not negative.
    pub(super) cosine: Unit,
    pub(super) material: &'s Material,
}

impl<'s> Interaction<'s> {
    /// Returns the interaction of a ray that has not hit anything yet.
    #[inline(always)]
    pub(super) fn new(ray: Ray) -> Self {
        static BLACK: Material = Material::BLACK;
        Self {
            ray,
            normal: Vec3::new(Unit::ZERO, Unit::ZERO, Unit::ZERO),
            cosine: Unit::ZERO,
            material: &BLACK,
        }
    }

    /// Returns the index of the object that the ray has hit.
    pub(super) fn object(&self) -> u16 {
        self.ray.leaves.object
    }

    /// Returns true if the ray came from behind the surface.
    pub(super) fn is_inside(&self) -> bool {
        self.ray.leaves.is_inside
    }

    /// Moves the ray to its hit point and computes the interaction. Returns false if `check_bounds`
    /// is true, the object is a plane, and the hit point is outside the clip box of the plane.
    #[inline(always)]
    pub(super) fn advance(
        &mut self,
        scene: &PreparedScene<'s>,
        hit: Hit,
        part: &PrimitivePart,
        check_bounds: bool,
    ) -> bool {
        let object = scene.object(hit.object);
        let ray = &mut self.ray;
        if hit.is_near {
            let coordinates = ray.at_near(hit.distance);
            if object.shape.is_near() || are_near(coordinates) {
                ray.origin.coordinates = coordinates;
            } else {
                ray.origin = ray.at_extended(SoftFloat::unordered(hit.distance));
            }
        } else {
            ray.origin = hit.extended_point(object, ray);
        }
        if check_bounds && !object.shape.covers(&ray.origin) {
            return false;
        }
        let SurfacePoint { normal, part } = object.shape.surface_at(&ray.origin, part);
        let is_horizontal = object.flags.intersects(SurfaceFlags::HORIZONTAL);
        let cosine = ray.direction.cosine_to_normal(normal, is_horizontal);
        let is_inside = cosine > Unit::ZERO;
        ray.leaves = OriginSurface::new(hit.object, part, is_inside, object.flags);
        self.normal = if is_inside { -normal } else { normal };
        self.cosine = cosine.abs();
        self.material = scene.material(object.texture.material(&ray.origin));
        true
    }

    /// Returns true if the surface looks the same from every direction.
    pub(super) fn is_matte(&self) -> bool {
        self.material.min_highlight_cosine == u32::MAX && !self.material.is_specular
    }

    /// Normalizes the direction of the ray. Needed if the ray was traced with a direction that is
    /// not normalized.
    #[inline(never)]
    pub(super) fn normalize_ray(&mut self) {
        self.ray.direction = self.ray.direction.unit_outlined();
        self.cosine = self.ray.direction.cosine(self.normal).abs();
    }
}
