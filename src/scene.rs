//! Describes scenes. A scene has a camera, lights, materials and objects in world units.
//!
//! A [`Scene`] is plain data that borrows slices, so it can be a `static` in flash. Its numbers
//! are of type [`Real`] (`I32F32`). The macros [`real!`](crate::real!), [`vec3!`](crate::vec3!) and
//! [`color!`](crate::color!) convert decimal literals at compile time. The types of this module
//! accept any value. [`SceneBuffer::prepare`](crate::SceneBuffer::prepare) validates the values.

mod builder;
mod camera;
mod counts;
mod error;
mod light;
mod material;
mod object;
mod shape;
mod shape_fields;
mod texture;
mod transfer;

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
pub use transfer::Transfer;

use crate::math::{Color, Real};

/// A scene in world units and linear colors.
///
/// [`SceneBuffer::prepare`](crate::SceneBuffer::prepare) accepts values in these ranges. The
/// ends of a range are included.
///
/// | value | range |
/// |---|---|
/// | coordinates of points, directions and clip boxes | -2^24 to 2^24 |
/// | sizes: radii, heights, checkerboard cells, smallest spheres of a sphereflake | 10^-6 to 2^24, and at least 2^-18 of half the side of the box around all bounded objects |
/// | channels of lights, emission, ambient light and background | 0 to 256 |
/// | lengths of lists | 0 to 65,535 |
///
/// If a field has a narrower range, its documentation states that range.
///
/// ```
/// use whitted::{Camera, Color, Light, Material, MaterialId, Object, Scene, color, real, vec3};
///
/// static SCENE: Scene = Scene {
///     lights: &[Light::point(vec3!(-6, 11, 7), Color::gray(real!(0.95)))],
///     materials: &[Material { kd: color!(0.6, 0.04, 0.03), ..Material::BLACK }],
///     objects: &[Object::sphere(vec3!(0, 1, 0), real!(1), MaterialId(0))],
///     ..Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)))
/// };
/// assert_eq!(SCENE.max_depth, 5);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The camera of the scene.
    pub camera: Camera,
    /// The point lights of the scene.
    pub lights: &'a [Light],
    /// The materials of the scene. Objects refer to them by [`MaterialId`].
    pub materials: &'a [Material],
    /// The objects of the scene.
    pub objects: &'a [Object],
    /// Ambient light `ia`, 0 to 256 per channel. A surface reflects `ka * ia`, where `ka` is the
    /// ambient coefficient of its material.
    pub ambient: Color<Real>,
    /// Background of the scene: the radiance of rays that hit no object.
    pub background: Background,
    /// Highlight model for those materials that have `None` in their field `shading`.
    pub shading: SpecularModel,
    /// Greatest number of reflections and refractions between the camera and a secondary ray, from
    /// 0 to 32. If it is 0, no secondary rays are traced.
    pub max_depth: u8,
    /// Minimum weight of a secondary ray, 0 to 1. The weight is the fraction of the ray's
    /// radiance that reaches the pixel. A ray is not traced if its weight is below this minimum
    /// in every channel.
    pub min_weight: Real,
    /// Transfer function of renderers, unless a program sets another
    /// [`Output`](crate::render::Output). Colors of the scene are linear in any case.
    pub transfer: Transfer,
}

impl Scene<'_> {
    /// Returns an empty scene. It has white ambient light, a black background, Phong
    /// highlights, a `max_depth` of 5, a `min_weight` of 1/255 and a linear transfer function.
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
            transfer: Transfer::Linear,
        }
    }
}

/// Radiance of rays that hit no object. Each channel of a background color is 0 to 256.
///
/// ```
/// use whitted::{Background, Camera, Scene, color, real, vec3};
///
/// let sky = Background::Gradient {
///     horizon: color!(0.6, 0.76, 0.9),
///     zenith: color!(0.03, 0.12, 0.42),
/// };
/// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
/// let scene = Scene { background: sky, ..Scene::new(camera) };
/// # let _ = scene;
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Background {
    /// Every direction has this color.
    Solid(Color<Real>),
    /// A vertical gradient. The color depends linearly on y, the vertical component of a ray's unit
    /// direction. The color is `horizon` at y = 0 and `zenith` at y = 1. Rays that point down get
    /// `horizon`.
    Gradient {
        /// Color at and below the horizon.
        horizon: Color<Real>,
        /// Color straight up.
        zenith: Color<Real>,
    },
}
