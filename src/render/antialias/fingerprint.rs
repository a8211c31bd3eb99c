use crate::math::{Color, Real};
use crate::observer::{Observer, RayKind, RayNode};

/// An observer that computes a hash for each camera ray. The hash depends on the object that the
/// ray hits, on the material of the object, and on the lights that illuminate the hit.
///
/// Objects that are seen by reflection or refraction do not change the hash, because their edges
/// are numerous and often faint. The comparison of colors finds those edges that are clearly
/// visible.
#[derive(Clone, Debug, Default)]
pub(super) struct Fingerprint {
    /// Hash of the most recent camera ray.
    pub(super) hash: u32,
    /// Hash of the shadow rays of the current camera ray.
    lights: u32,
    /// True from the start of a camera ray until the tracer reports the node of this ray.
    is_camera_ray: bool,
}

/// Transmittance of an unobstructed shadow ray.
const WHITE: Color<Real> = Color::gray(Real::ONE);

/// Adds a number to a hash. Multiplies the hash by the golden ratio (Knuth 1973) and rotates the
/// product. Because of the rotation, the high bits of this product affect the low bits of the next
/// product.
fn mix(hash: u32, number: u32) -> u32 {
    (hash ^ number).wrapping_mul(0x9e37_79b1).rotate_left(15)
}

impl Observer for Fingerprint {
    fn ray(&mut self, kind: RayKind) {
        if kind == RayKind::Camera {
            (self.lights, self.is_camera_ray) = (0, true);
        }
    }

    fn shadow(&mut self, light: u16, transmittance: Option<Color<Real>>) {
        // No shadow ray is traced to a light behind the surface. The hash treats such a light as
        // unobstructed. Shading is smooth where a surface turns away from a light, so there is no
        // edge there.
        if self.is_camera_ray && transmittance != Some(WHITE) {
            // The shift undoes a conversion: the tracer computes transmittance in Q15 and reports
            // it in Q32.
            let transmittance = transmittance.unwrap_or_default();
            let Color { r, g, b } = transmittance.map(|c| (c.to_bits() >> 17) as u32);
            let numbers = [1 + u32::from(light), r, g, b];
            self.lights = numbers.into_iter().fold(self.lights, mix);
        }
    }

    fn node(&mut self, node: &RayNode) {
        if self.is_camera_ray {
            let numbers = [node.object, node.material].map(|it| it.map_or(0, |n| 1 + u32::from(n)));
            self.hash = numbers.into_iter().fold(self.lights, mix);
            self.is_camera_ray = false;
        }
    }
}
