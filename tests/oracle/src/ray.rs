//! Rays, and how far they reach.

use crate::Float;
use crate::vec3::Vec3;

/// A ray with a unit direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray<F> {
    pub origin: Vec3<F>,
    pub direction: Vec3<F>,
    /// The surface that it starts on; none for an eye ray.
    pub start: Option<Start<F>>,
}

/// A surface: which object, and the center or origin of the part of it. Among
/// the spheres of a sphereflake the center tells which, since a walk computes
/// it the same, to the bit, every time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start<F> {
    pub object: usize,
    pub center: Vec3<F>,
}

impl<F: Float> Ray<F> {
    pub fn at(&self, t: F) -> Vec3<F> {
        self.origin + self.direction * t
    }

    /// The center of the part of this object that the ray starts on.
    #[inline]
    pub fn start_on(&self, object: usize) -> Option<&Vec3<F>> {
        self.start
            .as_ref()
            .filter(|start| start.object == object)
            .map(|start| &start.center)
    }
}

/// The stretch of a ray in which a crossing counts, its ends excluded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach<F> {
    pub near: F,
    pub far: F,
}

impl<F: Float> Reach<F> {
    /// False for what is not a number, too.
    #[inline]
    pub fn holds(&self, t: F) -> bool {
        self.near < t && t < self.far
    }

    /// Hands a crossing within reach to `visit`, which answers the new far end.
    #[inline]
    pub fn offer(&mut self, t: F, center: Vec3<F>, visit: &mut impl FnMut(F, Vec3<F>) -> F) {
        if self.holds(t) {
            self.far = visit(t, center);
        }
    }
}
