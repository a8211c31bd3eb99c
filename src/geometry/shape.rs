//! Surfaces of a prepared scene: where a ray meets them, and their normals.
//!
//! A shape answers for one ray; [`crate::intersect`] asks all of them. Each
//! first finds only distances, since the normal is wanted for the nearest
//! alone.

use crate::geometry::SurfaceFlags;
use crate::observer::ShapeKind;

use crate::geometry::{BoundingSphere, Form, Plane, Quadric, Sphere, Sphereflake};

/// What a shape can be. A tag of its own is told faster than one that is kept in a variant,
/// and takes no more memory.
#[derive(Clone, Copy, Debug)]
#[repr(u8)]
pub(crate) enum Shape {
    Sphere(Sphere),
    Plane(Plane),
    Quadric(Quadric),
    Sphereflake(Sphereflake),
}

impl Shape {
    /// A sphere around all of it; `None` if it is endless.
    pub(crate) fn bounding_sphere(&self) -> Option<BoundingSphere> {
        match self {
            Self::Sphere(sphere) => Some(sphere.bounding_sphere()),
            Self::Plane(_) => None,
            Self::Quadric(quadric) => quadric.bounding_sphere(),
            Self::Sphereflake(flake) => Some(flake.bounding_sphere()),
        }
    }

    /// What it is to the rays that start on it.
    pub(crate) fn nature(&self) -> SurfaceFlags {
        let finite = SurfaceFlags::FINITE;
        match self {
            Self::Sphere(_) => finite.and(SurfaceFlags::LEFT_OUTWARD, true),
            Self::Plane(plane) => SurfaceFlags::LEFT_OUTWARD
                .and(SurfaceFlags::LEFT_INWARD, true)
                .and(SurfaceFlags::OPEN, plane.bounds.is_some())
                .and(SurfaceFlags::LEVEL, plane.is_level()),
            Self::Quadric(quadric) => SurfaceFlags::NONE
                .and(SurfaceFlags::FINITE, !quadric.is_endless())
                .and(SurfaceFlags::OPEN, quadric.is_open()),
            Self::Sphereflake(_) => finite,
        }
    }

    /// What an observer is told that it is.
    #[inline(always)]
    pub(crate) fn kind(&self) -> ShapeKind {
        match self {
            Self::Sphere(_) => ShapeKind::Sphere,
            Self::Plane(_) => ShapeKind::Plane,
            Self::Quadric(quadric) => match quadric.form {
                Form::Ellipsoid(_) => ShapeKind::Ellipsoid,
                Form::Cylinder(_) => ShapeKind::Cylinder,
                Form::Cone(_) => ShapeKind::Cone,
                Form::Paraboloid(_) => ShapeKind::Paraboloid,
            },
            Self::Sphereflake(_) => ShapeKind::Sphereflake,
        }
    }
}
