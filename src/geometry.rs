//! Shapes of a prepared scene, rays, and bounds.

mod bounds;
pub(crate) mod limits;
mod normalization;
mod plane;
mod quadric;
mod ray;
mod shape;
mod sphere;
mod sphereflake;
mod texture;

pub(crate) use bounds::*;
pub(crate) use normalization::*;
pub(crate) use plane::*;
pub(crate) use quadric::*;
pub(crate) use ray::*;
pub(crate) use shape::Shape;
pub(crate) use sphere::*;
pub(crate) use sphereflake::*;
pub(crate) use texture::*;
