//! Scene description: plain data with borrowed lists, which can be stored in flash.

use crate::shape::Shape;
use crate::vec3::{Color, Vec3};

/// Scene with its camera.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Scene<'a, F> {
    pub camera: Camera<F>,
    pub settings: Settings<F>,
    pub lights: &'a [Light<F>],
    pub materials: &'a [Material<F>],
    pub objects: &'a [Object<F>],
}

/// Pinhole camera.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Camera<F> {
    pub eye: Vec3<F>,
    pub look_at: Vec3<F>,
    pub up: Vec3<F>,
    /// Vertical field of view in degrees.
    pub fovy_deg: F,
}

/// Settings of the whole scene.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Settings<F> {
    /// Greatest number of reflections and refractions in a row; 0 is ray casting.
    pub max_depth: u32,
    /// A secondary ray is dropped if its weight is less than this in every channel.
    pub min_weight: F,
    /// Greatest number of rays per pixel, without shadow rays. Rays are traced depth
    /// first, the reflected ray before the refracted one.
    pub ray_budget: u32,
    /// Least distance of a hit, in world units. A few rounding errors of the scene's
    /// size suffice, because a ray records the surface on which it starts.
    pub epsilon: F,
    /// Ambient light `ia`.
    pub ambient: Color<F>,
    pub background: Background<F>,
}

/// Radiance of rays that miss every object.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub enum Background<F> {
    Solid(Color<F>),
    /// Linear blend by the y component of the ray direction, 0 to 1. Below the horizon
    /// the background has the horizon's color.
    Gradient {
        horizon: Color<F>,
        zenith: Color<F>,
    },
}

/// Point light without distance falloff.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Light<F> {
    pub position: Vec3<F>,
    pub diffuse: Color<F>,
    pub specular: Color<F>,
}

/// Reflection, transmission and emission of a surface.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Material<F> {
    pub ka: Color<F>,
    pub kd: Color<F>,
    pub ks: Color<F>,
    pub kr: Color<F>,
    pub kt: Color<F>,
    pub le: Color<F>,
    pub shininess: F,
    pub ior: F,
    pub model: Model,
}

/// Formula of the specular term.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub enum Model {
    Phong,
    BlinnPhong,
}

/// Shape with its materials.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Object<F> {
    pub shape: Shape<F>,
    pub cover: Cover<F>,
}

/// Materials of an object, as indices into [`Scene::materials`].
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub enum Cover<F> {
    Material(usize),
    /// Checkerboard in world coordinates: the first material where
    /// `floor(a / size) + floor(b / size)` is even, else the second.
    Checker {
        size: F,
        axes: [Axis; 2],
        materials: [usize; 2],
    },
}

/// World axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub enum Axis {
    X,
    Y,
    Z,
}
