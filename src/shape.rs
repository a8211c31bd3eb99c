//! Surfaces of a prepared scene: where a ray meets them, and their normals.
//!
//! A shape answers for one ray; [`crate::intersect`] asks all of them. Each
//! first finds only distances, since the normal is wanted for the nearest
//! alone.

mod plane;
mod quadric;
mod sight;
mod sphere;
mod sphereflake;

use crate::Vec3;
use crate::num::Length;

pub(crate) use plane::{Bounds, Plane};
pub(crate) use quadric::{Cone, Cylinder, Ellipsoid, Form, Paraboloid, Quadric};
pub(crate) use sight::Sight;
pub(crate) use sphere::Sphere;
pub(crate) use sphereflake::{MAX_DEPTH as MAX_FLAKE_DEPTH, Parts, Path, Sphereflake};

/// What a shape can be.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    Sphere(Sphere),
    Plane(Plane),
    Quadric(Quadric),
    Sphereflake(Sphereflake),
}

impl Default for Shape {
    fn default() -> Self {
        Self::Sphere(Sphere::default())
    }
}

impl Shape {
    /// How a near point sees it, if it is a sphere or a plane.
    pub(crate) fn sight(&self, point: Vec3<Length>) -> Sight {
        match self {
            Self::Sphere(sphere) => sphere.sight(point),
            Self::Plane(plane) => plane.sight(point),
            Self::Quadric(_) | Self::Sphereflake(_) => Sight::NONE,
        }
    }

    /// Whether all of it is within ±1.
    #[inline]
    pub(crate) fn is_finite(&self) -> bool {
        match self {
            Self::Sphere(_) | Self::Sphereflake(_) => true,
            Self::Plane(_) => false,
            Self::Quadric(quadric) => !quadric.is_endless(),
        }
    }
}
