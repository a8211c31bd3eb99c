use crate::math::{Real, Vec3};
use crate::scene::{ClipBox, MaterialId, Shape, Texture};

/// A shape with a texture.
///
/// ```
/// use whitted::{MaterialId, Object, Shape, Texture, real, vec3};
///
/// let ball = Object::sphere(vec3!(0, 1, 0), real!(1), MaterialId(0));
/// let floor = Object::floor(real!(0), Texture::Uniform(MaterialId(1)));
/// // Any other shape is written with its fields.
/// let egg = Object {
///     shape: Shape::Ellipsoid { center: vec3!(2, 1.2, 0), radii: vec3!(0.8, 1.2, 0.8) },
///     texture: Texture::Uniform(MaterialId(0)),
/// };
/// # let _ = [ball, floor, egg];
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Object {
    /// Surface of the object.
    pub shape: Shape,
    /// Texture that selects the material for each point of the surface.
    pub texture: Texture,
}

impl Object {
    /// Returns a sphere that consists of one material.
    pub const fn sphere(center: Vec3<Real>, radius: Real, material: MaterialId) -> Self {
        Self {
            shape: Shape::Sphere { center, radius },
            texture: Texture::Uniform(material),
        }
    }

    /// Returns an upright sphereflake that consists of one material. Each smaller sphere has a
    /// third of the radius of the sphere that it touches.
    ///
    /// ```
    /// use whitted::{Camera, Material, MaterialId, Object, Real, Scene, SceneBuffer, real, vec3};
    ///
    /// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 0, 0), real!(33));
    /// let scene = Scene {
    ///     materials: &[Material::BLACK],
    ///     objects: &[Object::sphereflake(vec3!(0, 0, 0), Real::ONE, 6, MaterialId(0))],
    ///     ..Scene::new(camera)
    /// };
    /// let mut buffer = SceneBuffer::<1, 0, 1>::new(); // 3,257,437 spheres
    /// assert!(buffer.prepare(&scene).is_ok());
    /// ```
    pub const fn sphereflake(
        center: Vec3<Real>,
        radius: Real,
        depth: u8,
        material: MaterialId,
    ) -> Self {
        Self {
            shape: Shape::Sphereflake {
                center,
                radius,
                depth,
                ratio: Shape::FLAKE_RATIO,
                frame: Shape::FLAKE_FRAME,
            },
            texture: Texture::Uniform(material),
        }
    }

    /// Returns an unbounded horizontal plane at height `y`. The normal of the plane points up.
    pub const fn floor(y: Real, texture: Texture) -> Self {
        Self {
            shape: Shape::Plane {
                normal: Vec3::new(Real::ZERO, Real::ONE, Real::ZERO),
                point: Vec3::new(Real::ZERO, y, Real::ZERO),
                bounds: ClipBox::NONE,
            },
            texture,
        }
    }
}
