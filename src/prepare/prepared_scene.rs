//! A scene made ready for tracing: checked, scaled, in the formats of
//! [`crate::num`].
//!
//! Space is moved and scaled by a power of two so that the finite geometry,
//! with eye and lights, fits ±1; light is scaled by a power of two so that
//! lights fit 0 to 1.

use crate::geometry::Normalization;
use crate::geometry::{CullSphere, LightCone, Plane, Point, Shape, SurfaceFlags, Texture};
use crate::math::{Color, Factor, Length, Radiance, Real, Unit, Vec3, Weight, power};
use crate::scene;
use crate::scene::{CapacityError, SceneCounts};

/// The most secondary generations of rays.
pub(crate) const MAX_DEPTH: u8 = 32;

/// Where a prepared scene is put together.
///
/// Preparing and decoding are compiled once, not once per capacity.
pub(crate) trait SceneSink {
    fn clear(&mut self);
    fn push_object(&mut self, object: Object) -> Result<(), CapacityError>;
    fn push_light(&mut self, light: Light) -> Result<(), CapacityError>;
    fn push_material(&mut self, material: Material) -> Result<(), CapacityError>;
}

/// A scene ready to be rendered, in the memory of a [`SceneBuffer`](crate::SceneBuffer).
#[derive(Clone, Copy, Debug)]
pub struct PreparedScene<'b> {
    pub(crate) settings: Settings,
    pub(crate) objects: &'b [Object],
    pub(crate) lights: &'b [Light],
    pub(crate) materials: &'b [Material],
    /// The bounds of the finite objects.
    pub(crate) finite: &'b [CullSphere],
    /// Those of groups of them: of neighbors, if there are many.
    pub(crate) groups: &'b [CullSphere],
    /// The numbers of the endless objects.
    pub(crate) endless: &'b [u16],
    pub(crate) sights: LightCones<'b>,
}

/// How the lights see the bounds of the finite objects, in their order.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightCones<'b> {
    /// Light after light.
    pub(crate) all: &'b [LightCone],
    /// How many each light has: one for each finite object.
    pub(crate) count: usize,
}

impl<'b> LightCones<'b> {
    /// Those of a light.
    #[inline(always)]
    pub(crate) fn by_light(&self, index: usize) -> Option<&'b [LightCone]> {
        let first = index * self.count;
        self.all.get(first..first + self.count)
    }
}

/// All of a prepared scene that is not a list.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Settings {
    pub(crate) camera: Camera,
    /// The camera as it was authored, of which orbits need the whole.
    pub(crate) authored: scene::Camera,
    pub(crate) frame: Normalization,
    pub(crate) horizon: Color<Radiance>,
    pub(crate) zenith: Color<Radiance>,
    /// Whether these differ: derived.
    pub(crate) is_gradient: bool,
    /// Radiances are to be multiplied by 2^exposure to become those of the scene.
    pub(crate) exposure: u8,
    pub(crate) max_depth: u8,
    pub(crate) min_weight: Factor,
    /// Whether no material lets light through: derived.
    pub(crate) is_opaque: bool,
}

impl Settings {
    /// Before they are read.
    pub(crate) fn blank() -> Self {
        let nowhere = Vec3::new(Real::ZERO, Real::ZERO, Real::ZERO);
        Self {
            camera: Camera::default(),
            authored: scene::Camera::new(nowhere, nowhere, Real::ZERO),
            frame: Normalization::default(),
            horizon: Color::<Radiance>::BLACK,
            zenith: Color::<Radiance>::BLACK,
            is_gradient: false,
            exposure: 0,
            max_depth: 0,
            min_weight: Factor::ZERO,
            is_opaque: false,
        }
    }
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
#[derive(Clone, Copy, Debug)]
pub(crate) struct Object {
    pub(crate) shape: Shape,
    pub(crate) texture: Texture,
    /// That of the shape: derived.
    pub(crate) nature: SurfaceFlags,
}

impl Object {
    /// Nothing that a ray could meet, or before it is read.
    pub(crate) const NONE: Self = Self {
        shape: Shape::Plane(Plane::NONE),
        texture: Texture::Uniform(0),
        nature: SurfaceFlags::NONE,
    };

    /// A shape that is covered so.
    pub(crate) fn new(shape: Shape, texture: Texture) -> Self {
        let nature = shape.nature();
        Self {
            shape,
            texture,
            nature,
        }
    }
}

/// A point light.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Light {
    pub(crate) position: Vec3<Length>,
    pub(crate) diffuse: Color<Factor>,
    pub(crate) specular: Color<Factor>,
    /// Whether something endless may be between it and something finite.
    pub(crate) is_walled: bool,
    /// The mark of objects whose side that faces it nothing hides; no mark from the ninth
    /// light on.
    pub(crate) in_view: SurfaceFlags,
}

impl Light {
    /// What is left of it behind a filter.
    #[inline(never)]
    pub(crate) fn filtered(&self, filter: Color<Factor>) -> Self {
        Self {
            diffuse: self.diffuse.filtered(filter),
            specular: self.specular.filtered(filter),
            ..*self
        }
    }
}

/// What a surface does to light.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Material {
    /// `le + ka * ia`, which takes no light.
    pub(crate) glow: Color<Radiance>,
    pub(crate) kd: Color<Factor>,
    pub(crate) ks: Color<Factor>,
    pub(crate) kr: Color<Weight>,
    pub(crate) kt: Color<Weight>,
    /// `U16F16`, 1 to 4096.
    pub(crate) shininess: u32,
    /// Whether it mirrors light or lets it through: derived.
    pub(crate) branches: bool,
    /// The least cosine of which a highlight can be seen, `U1F31`; more than 1 if none
    /// can: derived.
    pub(crate) dimmest: u32,
    /// Index of refraction, 1 to 4, and its reciprocal.
    pub(crate) ior: Length,
    pub(crate) inverse_ior: Length,
    pub(crate) blinn: bool,
}

impl Material {
    /// Black.
    const NONE: Self = Self {
        glow: Color::<Radiance>::BLACK,
        kd: Color::<Factor>::BLACK,
        ks: Color::<Factor>::BLACK,
        kr: Color::<Weight>::BLACK,
        kt: Color::<Weight>::BLACK,
        shininess: 0,
        branches: false,
        dimmest: 0,
        ior: Length::ONE,
        inverse_ior: Length::ONE,
        blinn: false,
    };

    #[inline(always)]
    pub(crate) fn none() -> &'static Self {
        static NONE: Material = Material::NONE;
        &NONE
    }

    /// The material with what follows from its coefficients.
    pub(crate) fn complete(self) -> Self {
        Self {
            branches: !self.kr.is_black() || !self.kt.is_black(),
            dimmest: if self.ks.is_black() {
                u32::MAX
            } else {
                dimmest(self.shininess)
            },
            ..self
        }
    }
}

/// The least base, `U1F31`, of which a power with an exponent from 1, `U16F16`,
/// is at least half a step of a [`Factor`]; or one below it.
fn dimmest(exponent: u32) -> u32 {
    // The fraction of the exponent would only raise it.
    let is_dim = |base| power(base, exponent >> 16 << 16) < 1 << 15;
    let (mut dim, mut bright) = (0, 1 << 31);
    while bright - dim > 1 {
        let middle = (dim + bright) / 2;
        if is_dim(middle) {
            dim = middle;
        } else {
            bright = middle;
        }
    }
    bright
}

impl<'b> PreparedScene<'b> {
    /// Secondary generations of rays.
    pub fn max_depth(&self) -> u8 {
        self.settings.max_depth
    }

    /// The camera, in world units, to be moved by
    /// [`set_camera`](Self::set_camera).
    pub fn camera(&self) -> scene::Camera {
        self.settings.authored
    }

    /// Numbers of objects, lights and materials.
    pub fn counts(&self) -> SceneCounts {
        SceneCounts::EMPTY
            .objects(self.objects.len())
            .lights(self.lights.len())
            .materials(self.materials.len())
    }

    /// The material of a number that an object has.
    ///
    /// Preparing and decoding see to it that there is one.
    #[inline(always)]
    pub(crate) fn material(&self, index: u16) -> &'b Material {
        self.materials
            .get(usize::from(index))
            .unwrap_or(Material::none())
    }

    /// The object of a number that a hit has.
    #[inline(always)]
    pub(crate) fn object(&self, number: u16) -> &'b Object {
        static NONE: Object = Object::NONE;
        self.objects.get(usize::from(number)).unwrap_or(&NONE)
    }

    /// What an object lets through at a point of its surface.
    #[inline(never)]
    pub(crate) fn transmitted(&self, object: &Object, point: Point) -> Color<Factor> {
        self.material(object.texture.material(&point)).kt.narrowed()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the documentation of [`SceneBuffer`] says.
    #[test]
    fn items_take_as_many_bytes_as_documented() {
        assert_eq!(size_of::<Object>(), 112);
        assert_eq!(size_of::<CullSphere>(), 16);
        assert_eq!(size_of::<LightCone>(), 12);
        assert_eq!(size_of::<Light>(), 28);
        assert_eq!(size_of::<Material>(), 68);
    }
}
