//! The authored scene: what a person writes down, in world units.
//!
//! Plain data that borrows slices, so a scene can be `static` in flash. Its
//! numbers are [`Real`]: range and precision to spare, and constants through
//! [`Real::lit`]. Nothing here is checked; preparing a scene does that.

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

/// A scene to be rendered, in world units and linear colors.
///
/// What preparing accepts, both ends included:
///
/// * coordinates of points and directions, and ends of bounds: -2^24 to 2^24;
/// * sizes, such as radii, heights, cells of a checkerboard and the smallest spheres of a
///   sphereflake: 10^-6 to 2^24, and at least 2^-18 of half the box around all that is
///   finite;
/// * channels of lights, emission, ambient light and background: 0 to 256;
/// * lists of up to 65,535 items.
///
/// The documentation of fields says what else holds.
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
    /// Where the picture is taken from.
    pub camera: Camera,
    /// The point lights.
    pub lights: &'a [Light],
    /// What objects name by [`MaterialId`].
    pub materials: &'a [Material],
    /// What is to be seen.
    pub objects: &'a [Object],
    /// Ambient light `ia`, 0 to 256 a channel, which a material reflects by its `ka`.
    pub ambient: Color<Real>,
    /// What a ray that hits nothing brings back, 0 to 256 a channel.
    pub background: Background,
    /// The highlight model of materials that name none.
    pub shading: SpecularModel,
    /// Secondary generations of rays, 0 (plain ray casting) to 32.
    pub max_depth: u8,
    /// A branch of the ray tree ends where its weight is below this in every
    /// channel: 0 (never) to 1.
    pub min_weight: Real,
}

impl Scene<'_> {
    /// An empty scene: white ambient light, black background, Phong, five
    /// generations, weights down to 1/255.
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
            // 1/255, rounded up.
            min_weight: Real::from_bits(0x0101_0102),
        }
    }
}

/// What a ray that hits nothing brings back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Background {
    /// One color all around.
    Solid(Color<Real>),
    /// A sky: `horizon` for rays that are level or fall, blended linearly in
    /// the y component of the unit direction to `zenith` straight up.
    Gradient {
        /// At the horizon and below.
        horizon: Color<Real>,
        /// Straight up.
        zenith: Color<Real>,
    },
}
