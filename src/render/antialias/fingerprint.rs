use crate::math::{Color, Real};
use crate::observer::{Observer, RayKind, RayNode};

/// A key of what the last eye ray met: the object, its material, and which lights
/// reach it.
///
/// What is mirrored or seen through a surface has no part in it, since its
/// edges are often faint and always many; color tells those that matter.
#[derive(Clone, Debug, Default)]
pub(super) struct Fingerprint {
    pub(super) key: u32,
    /// The lights that do or do not reach where it ends.
    lights: u32,
    is_eye_ray: bool,
}

/// All of a light.
const WHITE: Color<Real> = Color::gray(Real::ONE);

/// Takes one more number into a hash: multiplication by the golden ratio (Knuth
/// 1973), turned so that high bits count as much as low ones.
fn mixed(hash: u32, number: u32) -> u32 {
    (hash ^ number).wrapping_mul(0x9e37_79b1).rotate_left(15)
}

impl Observer for Fingerprint {
    #[inline(always)]
    fn ray(&mut self, kind: RayKind) {
        if kind == RayKind::Camera {
            (self.lights, self.is_eye_ray) = (0, true);
        }
    }

    #[inline]
    fn shadow(&mut self, light: u16, left: Option<Color<Real>>) {
        // Where a surface turns away from a light its shade is smooth, so a light
        // behind it is the same as one that reaches it.
        if self.is_eye_ray && left != Some(WHITE) {
            // Q32 -> Q15, which they are made of.
            let left = left.unwrap_or_default().map(|c| (c.to_bits() >> 17) as u32);
            let numbers = [1 + u32::from(light), left.r, left.g, left.b];
            self.lights = numbers.into_iter().fold(self.lights, mixed);
        }
    }

    #[inline]
    fn node(&mut self, node: &RayNode) {
        if self.is_eye_ray {
            let numbers = [node.object, node.material].map(|it| it.map_or(0, |n| 1 + u32::from(n)));
            self.key = numbers.into_iter().fold(self.lights, mixed);
            self.is_eye_ray = false;
        }
    }
}
