use super::intersect::Hit;
use crate::geometry::{OriginSurface, PrimitivePart, Ray, SurfaceFlags, SurfacePoint, are_near};
use crate::math::{SoftFloat, Unit, Vec3};
use crate::prepare::{Material, PreparedScene};

/// A ray, and everything that shading needs to know about its hit.
///
/// The only place where point, normal, side and material of a hit are computed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interaction<'s> {
    /// The ray. Once it has hit a surface, its origin is the hit point, and it leaves that
    /// surface on the side it came from.
    pub(super) ray: Ray,
    /// Shading normal, on the side of the ray.
    pub(super) normal: Vec3<Unit>,
    /// Cosine of the angle of incidence, `-V · n`: not negative.
    pub(super) cosine: Unit,
    pub(super) material: &'s Material,
}

impl<'s> Interaction<'s> {
    /// Returns a ray that has not hit anything yet.
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

    /// Index of the object that was hit.
    pub(super) fn object(&self) -> u16 {
        self.ray.leaves.object
    }

    /// True if the ray came from behind the surface.
    pub(super) fn is_inside(&self) -> bool {
        self.ray.leaves.is_inside
    }

    /// Moves the ray to its hit and computes the interaction. Returns false if the point must
    /// be checked against the clip box of a plane and is outside.
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

    /// Normalizes the direction of a ray that was traced without a unit direction.
    #[inline(never)]
    pub(super) fn normalize_ray(&mut self) {
        self.ray.direction = self.ray.direction.unit_outlined();
        self.cosine = self.ray.direction.cosine(self.normal).abs();
    }
}
