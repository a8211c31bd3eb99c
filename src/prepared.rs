//! A scene made ready for tracing: checked, scaled, in the formats of
//! [`crate::num`].
//!
//! Space is moved and scaled by a power of two so that the finite geometry,
//! with eye and lights, fits ±1; light is scaled by a power of two so that
//! lights fit 0 to 1.

use heapless::Vec;

use crate::num::{Factor, Length, Radiance, Real, Unit};
use crate::shape::Shape;
use crate::texture::Texture;
use crate::{Color, DecodeError, Scene, SceneError, Vec3, compiled, prepare};

/// Room for a prepared scene, in a `static` or on the stack: so many objects,
/// lights and materials.
///
/// An object takes 72 bytes, a light 24, a material 52.
///
/// ```
/// use whitted::{Camera, Real, Scene, SceneBuffer, Vec3};
///
/// let camera = Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33"));
/// let mut buffer = SceneBuffer::<8, 2, 8>::new();
/// let scene = buffer.prepare(&Scene::new(camera))?;
/// assert_eq!(scene.max_depth(), 5);
/// # Ok::<(), whitted::SceneError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct SceneBuffer<const OBJECTS: usize, const LIGHTS: usize, const MATERIALS: usize> {
    objects: Vec<Object, OBJECTS>,
    lights: Vec<Light, LIGHTS>,
    materials: Vec<Material, MATERIALS>,
}

impl<const OBJECTS: usize, const LIGHTS: usize, const MATERIALS: usize>
    SceneBuffer<OBJECTS, LIGHTS, MATERIALS>
{
    /// An empty buffer.
    pub const fn new() -> Self {
        Self {
            objects: Vec::new(),
            lights: Vec::new(),
            materials: Vec::new(),
        }
    }

    /// Checks a scene and makes it ready for tracing, in integer arithmetic
    /// alone: it comes out the same on every target.
    ///
    /// # Errors
    /// The first item that cannot be rendered, and what is wrong with it.
    pub fn prepare(&mut self, scene: &Scene<'_>) -> Result<PreparedScene<'_>, SceneError> {
        let settings = prepare::prepare(scene, self)?;
        Ok(self.scene(settings))
    }

    /// Reads a scene that [`PreparedScene::encode`] wrote.
    ///
    /// # Errors
    /// Whatever keeps the bytes from being such a scene. The buffer is then empty.
    pub fn decode(&mut self, bytes: &[u8]) -> Result<PreparedScene<'_>, DecodeError> {
        let decoded = compiled::decode(bytes, self);
        if decoded.is_err() {
            self.clear();
        }
        decoded.map(|settings| self.scene(settings))
    }

    fn scene(&self, settings: Settings) -> PreparedScene<'_> {
        PreparedScene {
            settings,
            objects: &self.objects,
            lights: &self.lights,
            materials: &self.materials,
        }
    }
}

/// Where a prepared scene is put together.
///
/// Preparing and decoding are compiled once, not once per capacity.
pub(crate) trait Room {
    fn clear(&mut self);
    fn push_object(&mut self, object: Object) -> Result<(), SceneError>;
    fn push_light(&mut self, light: Light) -> Result<(), SceneError>;
    fn push_material(&mut self, material: Material) -> Result<(), SceneError>;
}

impl<const OBJECTS: usize, const LIGHTS: usize, const MATERIALS: usize> Room
    for SceneBuffer<OBJECTS, LIGHTS, MATERIALS>
{
    fn clear(&mut self) {
        self.objects.clear();
        self.lights.clear();
        self.materials.clear();
    }

    fn push_object(&mut self, object: Object) -> Result<(), SceneError> {
        self.objects
            .push(object)
            .map_err(|_| SceneError::too_many("objects", OBJECTS))
    }

    fn push_light(&mut self, light: Light) -> Result<(), SceneError> {
        self.lights
            .push(light)
            .map_err(|_| SceneError::too_many("lights", LIGHTS))
    }

    fn push_material(&mut self, material: Material) -> Result<(), SceneError> {
        self.materials
            .push(material)
            .map_err(|_| SceneError::too_many("materials", MATERIALS))
    }
}

/// A scene ready to be rendered, in the memory of a [`SceneBuffer`].
#[derive(Clone, Copy, Debug)]
pub struct PreparedScene<'b> {
    pub(crate) settings: Settings,
    pub(crate) objects: &'b [Object],
    pub(crate) lights: &'b [Light],
    pub(crate) materials: &'b [Material],
}

impl PreparedScene<'_> {
    /// Secondary generations of rays.
    pub fn max_depth(&self) -> u8 {
        self.settings.max_depth
    }

    /// How many objects, lights and materials there are.
    pub fn counts(&self) -> [usize; 3] {
        [self.objects.len(), self.lights.len(), self.materials.len()]
    }

    /// Changes the number of secondary generations.
    ///
    /// # Errors
    /// Above 32.
    pub fn set_max_depth(&mut self, max_depth: u8) -> Result<(), SceneError> {
        self.settings.max_depth = prepare::max_depth(max_depth)?;
        Ok(())
    }

    /// Changes the weight below which a branch of the ray tree ends.
    ///
    /// # Errors
    /// Outside of 0 to 1.
    pub fn set_min_weight(&mut self, min_weight: Real) -> Result<(), SceneError> {
        self.settings.min_weight = prepare::min_weight(min_weight)?;
        Ok(())
    }

    /// How many bytes [`encode`](Self::encode) writes.
    pub fn encoded_len(&self) -> usize {
        compiled::encoded_len(self)
    }

    /// Writes the scene as bytes that [`SceneBuffer::decode`] reads, and says
    /// how many; `None` if `out` is too short.
    ///
    /// All integers are little-endian and already scaled. The bytes begin with
    /// a version and end with a CRC-32.
    pub fn encode(&self, out: &mut [u8]) -> Option<usize> {
        compiled::encode(self, out)
    }
}

/// All of a prepared scene that is not a list.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Settings {
    pub(crate) camera: Camera,
    pub(crate) horizon: Color<Factor>,
    pub(crate) zenith: Color<Factor>,
    /// Radiances are to be multiplied by 2^exposure to become those of the scene.
    pub(crate) exposure: u8,
    pub(crate) max_depth: u8,
    pub(crate) min_weight: Factor,
}

/// A camera with an orthonormal base.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Camera {
    pub(crate) eye: Vec3<Length>,
    pub(crate) forward: Vec3<Unit>,
    pub(crate) right: Vec3<Unit>,
    pub(crate) up: Vec3<Unit>,
    /// tan(fovy / 2) as `U4F28`: below 11.5.
    pub(crate) tangent: u32,
}

/// A shape and what covers it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Object {
    pub(crate) shape: Shape,
    pub(crate) texture: Texture,
}

/// A point light.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Light {
    pub(crate) position: Vec3<Length>,
    pub(crate) diffuse: Color<Factor>,
    pub(crate) specular: Color<Factor>,
}

/// What a surface does to light.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Material {
    /// `le + ka * ia`, which takes no light.
    pub(crate) glow: Color<Radiance>,
    pub(crate) kd: Color<Factor>,
    pub(crate) ks: Color<Factor>,
    pub(crate) kr: Color<Factor>,
    pub(crate) kt: Color<Factor>,
    /// `U16F16`, 1 to 4096.
    pub(crate) shininess: u32,
    /// Index of refraction, 1 to 4, and its reciprocal.
    pub(crate) ior: Length,
    pub(crate) inverse_ior: Length,
    pub(crate) blinn: bool,
}

impl<'b> PreparedScene<'b> {
    /// The material of a number that an object has.
    ///
    /// Preparing and decoding see to it that there is one.
    #[inline(always)]
    pub(crate) fn material(&self, index: u16) -> Option<&'b Material> {
        self.materials.get(usize::from(index))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the documentation of [`SceneBuffer`] says.
    #[test]
    fn items_take_as_many_bytes_as_documented() {
        assert_eq!(size_of::<Object>(), 72);
        assert_eq!(size_of::<Light>(), 24);
        assert_eq!(size_of::<Material>(), 52);
    }
}
