//! Rays and the interval of t in which a hit counts.

use crate::Float;
use crate::vec3::Vec3;

/// Ray with a unit direction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ray<F> {
    pub origin: Vec3<F>,
    pub direction: Vec3<F>,
    /// Surface on which the ray starts; `None` for a camera ray.
    pub start: Option<SurfaceId<F>>,
}

/// Identifies a surface by its object and the center or origin of its part. The
/// center distinguishes the spheres of a sphereflake: every traversal computes it
/// with the same bits.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SurfaceId<F> {
    pub object: usize,
    pub center: Vec3<F>,
}

impl<F: Float> Ray<F> {
    /// Returns the point at distance `t`.
    pub fn at(&self, t: F) -> Vec3<F> {
        self.origin + self.direction * t
    }

    /// Returns the center of the part on which the ray starts, if it starts on this
    /// object.
    #[inline]
    pub fn start_on(&self, object: usize) -> Option<&Vec3<F>> {
        self.start
            .as_ref()
            .filter(|start| start.object == object)
            .map(|start| &start.center)
    }
}

/// Open interval of t in which a hit counts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Interval<F> {
    pub near: F,
    pub far: F,
}

impl<F: Float> Interval<F> {
    /// Returns true if `t` is inside the interval; false for NaN.
    #[inline]
    pub fn contains(&self, t: F) -> bool {
        self.near < t && t < self.far
    }

    /// Passes a hit inside the interval to `visit`, which returns the new far end.
    #[inline]
    pub fn report(&mut self, t: F, center: Vec3<F>, visit: &mut impl FnMut(F, Vec3<F>) -> F) {
        if self.contains(t) {
            self.far = visit(t, center);
        }
    }
}
