//! Authored scenes: camera, lights, materials and objects in world units.
//!
//! A [`Scene`] is plain data that borrows slices, so it can be a `static` in flash. Its numbers
//! are [`Real`] (`I32F32`), which [`Real::lit`] parses at compile time. The types of this module
//! accept any value; [`SceneBuffer::prepare`](crate::SceneBuffer::prepare) validates them.

mod builder;
mod camera;
mod counts;
mod error;
mod light;
mod material;
mod object;
mod shape;
mod texture;

pub use builder::SceneBuilder;
pub use camera::Camera;
pub use counts::SceneCounts;
pub(crate) use error::CapacityError;
pub use error::{DecodeError, SceneError, SceneItem, SceneProblem};
pub use light::Light;
pub use material::{Material, MaterialId, SpecularModel, ior};
pub use object::Object;
pub use shape::{ClipBox, Shape};
pub use texture::{Axis, Texture};

use crate::math::{Color, Real};

/// Scene in world units and linear colors.
///
/// [`SceneBuffer::prepare`](crate::SceneBuffer::prepare) accepts these ranges, ends included:
///
/// | value | range |
/// |---|---|
/// | coordinates of points, directions and clip boxes | -2^24 to 2^24 |
/// | sizes: radii, heights, checkerboard cells, smallest spheres of a sphereflake | 10^-6 to 2^24, and at least 2^-18 of half the side of the box around all bounded objects |
/// | channels of lights, emission, ambient light and background | 0 to 256 |
/// | lengths of lists | 0 to 65,535 |
///
/// Narrower ranges are stated at the fields that have them.
///
/// ```
/// use whitted::{Camera, Color, Light, Material, MaterialId, Object, Real, Scene, Vec3};
///
/// static SCENE: Scene = Scene {
///     lights: &[Light::point(Vec3::lit("-6", "11", "7"), Color::gray(Real::lit("0.95")))],
///     materials: &[Material { kd: Color::lit("0.6", "0.04", "0.03"), ..Material::BLACK }],
///     objects: &[Object::sphere(Vec3::lit("0", "1", "0"), Real::lit("1"), MaterialId(0))],
///     ..Scene::new(Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33")))
/// };
/// assert_eq!(SCENE.max_depth, 5);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The camera.
    pub camera: Camera,
    /// The point lights.
    pub lights: &'a [Light],
    /// The materials, which objects refer to by [`MaterialId`].
    pub materials: &'a [Material],
    /// The objects.
    pub objects: &'a [Object],
    /// Ambient light `ia`, 0 to 256 per channel. A material reflects `ka * ia` of it.
    pub ambient: Color<Real>,
    /// Radiance of rays that hit no object.
    pub background: Background,
    /// Highlight model of materials whose `shading` is `None`.
    pub shading: SpecularModel,
    /// Greatest number of reflections and refractions in a row, 0 (ray casting) to 32.
    pub max_depth: u8,
    /// Least weight of a secondary ray, 0 to 1. A ray is not traced if its contribution to the
    /// pixel is below this weight in every channel.
    pub min_weight: Real,
}

impl Scene<'_> {
    /// Returns an empty scene with white ambient light, a black background, Phong highlights,
    /// `max_depth` 5 and `min_weight` 1/255.
    pub const fn new(camera: Camera) -> Self {
        Self {
            camera,
            lights: &[],
            materials: &[],
            objects: &[],
            ambient: Color::gray(Real::ONE),
            background: Background::Solid(Color::gray(Real::ZERO)),
            shading: SpecularModel::Phong,
            max_depth: 5,
            // 1/255 in Q32, rounded up.
            min_weight: Real::from_bits(0x0101_0102),
        }
    }
}

/// Radiance of rays that hit no object. Channels are 0 to 256.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Background {
    /// One color in every direction.
    Solid(Color<Real>),
    /// A vertical gradient, linear in the y component of the unit direction from `horizon` at 0
    /// to `zenith` at 1. Rays that point down get `horizon`.
    Gradient {
        /// Color at the horizon and below.
        horizon: Color<Real>,
        /// Color straight up.
        zenith: Color<Real>,
    },
}
