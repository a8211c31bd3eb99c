//! What a scene is: plain data that borrows its lists, so that it may lie in
//! flash.

use crate::shape::Shape;
use crate::vec3::{Color, Vec3};

/// All that a picture is computed from.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Scene<'a, F> {
    pub camera: Camera<F>,
    pub settings: Settings<F>,
    pub lights: &'a [Light<F>],
    pub materials: &'a [Material<F>],
    pub objects: &'a [Object<F>],
}

/// Where the picture is seen from.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Camera<F> {
    pub eye: Vec3<F>,
    pub look_at: Vec3<F>,
    pub up: Vec3<F>,
    /// Vertical field of view in degrees.
    pub fovy_deg: F,
}

/// What holds for the whole scene.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Settings<F> {
    /// Generations of secondary rays; 0 is plain ray casting.
    pub max_depth: u32,
    /// A branch that counts for less than this in every channel is cut.
    pub min_weight: F,
    /// Rays of the tree that a pixel may cost, shadow rays not counted. They
    /// are spent depth first, the reflected ray before the refracted one.
    pub ray_budget: u32,
    /// A hit nearer than this is passed over, in world units. A ray knows the
    /// surface that it starts on, so a few roundings of the world's size do.
    pub epsilon: F,
    /// The ambient light, `ia`.
    pub ambient: Color<F>,
    pub background: Background<F>,
}

/// What a ray that hits nothing brings back.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub enum Background<F> {
    Solid(Color<F>),
    /// Blended by the height of the ray's direction; the horizon's below it.
    Gradient {
        horizon: Color<F>,
        zenith: Color<F>,
    },
}

/// A point light.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Light<F> {
    pub position: Vec3<F>,
    pub diffuse: Color<F>,
    pub specular: Color<F>,
}

/// How a surface answers light.
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

/// The specular term's formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub enum Model {
    Phong,
    BlinnPhong,
}

/// A shape and what covers it.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub struct Object<F> {
    pub shape: Shape<F>,
    pub cover: Cover<F>,
}

/// Which material, by its place in [`Scene::materials`], lies where.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub enum Cover<F> {
    Material(usize),
    /// The first material where the floors of the two world coordinates,
    /// counted in squares of `size`, have an even sum; else the second.
    Checker {
        size: F,
        axes: [Axis; 2],
        materials: [usize; 2],
    },
}

/// An axis of the world.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize, serde::Serialize))]
pub enum Axis {
    X,
    Y,
    Z,
}
