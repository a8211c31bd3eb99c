use super::interaction::Interaction;
use super::optics;
use crate::geometry::{Ray, SurfaceFlags};
use crate::math::{Color, Unit, Vec3, Weight};
use crate::prepare::Material;

/// Describes the two rays that leave a transparent surface: a reflected and a transmitted ray.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scattering {
    pub(super) reflected: Color<Weight>,
    /// Weight and direction of the transmitted ray, or `None` at total internal reflection.
    pub(super) transmitted: Option<(Color<Weight>, Vec3<Unit>)>,
}

impl Interaction<'_> {
    /// Computes the reflected and the transmitted ray. At total internal reflection, all light
    /// is reflected and there is no transmitted ray.
    pub(super) fn scatter(&self) -> Scattering {
        let Material { kr, kt, .. } = *self.material;
        let direction = if self.ray.leaves.flags.intersects(SurfaceFlags::OPEN) {
            Some(self.ray.direction)
        } else {
            self.refract()
        };
        match direction {
            Some(direction) => Scattering {
                reflected: kr,
                transmitted: Some((kt, direction)),
            },
            None => Scattering {
                reflected: Color::<Weight>::ALL,
                transmitted: None,
            },
        }
    }

    #[cold]
    #[inline(never)]
    fn refract(&self) -> Option<Vec3<Unit>> {
        let Material {
            ior, inverse_ior, ..
        } = *self.material;
        let eta = if self.is_inside() { ior } else { inverse_ior };
        optics::refracted(self.ray.direction, self.normal, self.cosine, eta)
    }

    /// Replaces the ray by the reflected ray.
    #[inline(never)]
    pub(super) fn reflect(&mut self) {
        self.ray.direction = optics::mirrored(self.ray.direction, self.normal, self.cosine);
    }

    /// Returns the transmitted ray, which continues on the other side of the surface.
    pub(super) fn transmitted_ray(&self, direction: Vec3<Unit>) -> Ray {
        Ray {
            origin: self.ray.origin,
            direction,
            leaves: self.ray.leaves.other_side(),
        }
    }
}
