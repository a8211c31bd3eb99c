//! Surfaces of a prepared scene: where a ray meets them, and their normals.
//!
//! A shape answers for one ray; [`crate::intersect`] asks all of them. Each
//! first finds only distances, since the normal is wanted for the nearest
//! alone.

mod plane;
mod sphere;

pub(crate) use plane::{Bounds, Plane};
pub(crate) use sphere::Sphere;

/// What a shape can be.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    Sphere(Sphere),
    Plane(Plane),
}

impl Default for Shape {
    fn default() -> Self {
        Self::Sphere(Sphere::default())
    }
}
