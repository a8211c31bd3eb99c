//! Prepared shapes, rays and bounds.
//!
//! Each shape has its own file or folder with all code of the shape: validation,
//! preparation, bounds, intersection, occlusion, normal, and the fields that a compiled
//! scene stores.

mod bounding_sphere;
mod clip_box;
mod cull_sphere;
mod culling_tests;
mod extent;
mod light_cone;
pub(crate) mod limits;
mod low_precision;
mod normalization;
mod plane;
mod point;
mod primitive;
#[cfg(feature = "quadrics")]
mod quadric;
mod ray;
mod shadow_segment;
mod shape;
mod sphere;
#[cfg(feature = "sphereflake")]
mod sphereflake;
mod surface;
mod texture;
pub(crate) mod valid;

pub(crate) use bounding_sphere::BoundingSphere;
pub(crate) use cull_sphere::CullSphere;
pub(crate) use extent::Extent;
pub(crate) use light_cone::LightCone;
pub(crate) use low_precision::{normalize_q16, to_q12, to_q16};
pub(crate) use normalization::{MAX_EXPONENT, Normalization};
pub(crate) use plane::Plane;
pub(crate) use point::{NEAR, Point, are_near};
pub(crate) use primitive::{PrimitivePart, SurfacePoint};
pub(crate) use ray::Ray;
pub(crate) use shadow_segment::ShadowSegment;
pub(crate) use shape::{Shape, extend, max_exponent, validate};
#[cfg(test)]
pub(crate) use sphere::Sphere;
pub(crate) use surface::{OriginSurface, SurfaceFlags};
pub(crate) use texture::{Checker, Texture};
