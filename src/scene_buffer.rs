//! The caller's memory for a prepared scene, and the ways into it.

use heapless::Vec;

use crate::geometry::{CullSphere, LightCone, SurfaceFlags};
use crate::math::Real;
use crate::prepare::culling::{Index, look, seclude, unveil};
use crate::prepare::{Light, LightCones, Material, Object, PreparedScene, SceneSink, Settings};
use crate::scene::{Camera, CapacityError, DecodeError, Scene, SceneError};
use crate::{codec, prepare};

/// Room for a prepared scene, in a `static` or on the stack: so many objects,
/// lights and materials.
///
/// An object takes 112 bytes, 34 more for its bounds and 12 for each light; a
/// light takes 28, a material 68.
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
#[derive(Clone, Debug)]
pub struct SceneBuffer<const OBJECTS: usize, const LIGHTS: usize, const MATERIALS: usize> {
    objects: Vec<Object, OBJECTS>,
    lights: Vec<Light, LIGHTS>,
    materials: Vec<Material, MATERIALS>,
    finite: Vec<CullSphere, OBJECTS>,
    groups: Vec<CullSphere, OBJECTS>,
    endless: Vec<u16, OBJECTS>,
    /// How each light sees the finite objects, light after light.
    sights: [[LightCone; OBJECTS]; LIGHTS],
}

impl<const OBJECTS: usize, const LIGHTS: usize, const MATERIALS: usize> Default
    for SceneBuffer<OBJECTS, LIGHTS, MATERIALS>
{
    fn default() -> Self {
        Self::new()
    }
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
            finite: Vec::new(),
            groups: Vec::new(),
            endless: Vec::new(),
            sights: [[LightCone::NONE; OBJECTS]; LIGHTS],
        }
    }

    /// Checks a scene and makes it ready for tracing, in integer arithmetic
    /// alone: it comes out the same on every target.
    ///
    /// # Errors
    /// The first item that cannot be rendered, and what is wrong with it.
    pub fn prepare<'b>(&'b mut self, scene: &Scene<'b>) -> Result<PreparedScene<'b>, SceneError> {
        let settings = prepare::prepare(scene, self)?;
        Ok(self.scene(settings))
    }

    /// Reads a scene that [`PreparedScene::encode`] wrote.
    ///
    /// # Errors
    /// Whatever keeps the bytes from being such a scene. The buffer is then empty.
    pub fn decode<'b>(&'b mut self, bytes: &'b [u8]) -> Result<PreparedScene<'b>, DecodeError> {
        let decoded = codec::decode(bytes, self);
        if decoded.is_err() {
            self.clear();
        }
        let settings = decoded?;
        Ok(self.scene(settings))
    }

    fn scene(&mut self, settings: Settings) -> PreparedScene<'_> {
        let index = Index {
            finite: self.finite.as_mut_view(),
            groups: self.groups.as_mut_view(),
            endless: self.endless.as_mut_view(),
        };
        index.fill(&self.objects);
        seclude(&mut self.objects, &self.materials);
        let sights = self.sights.as_flattened_mut();
        let mut sights = sights.chunks_mut(self.finite.len().max(1));
        for light in &mut self.lights {
            let own = sights.next().unwrap_or_default();
            look(light, &self.objects, &self.endless, own);
        }
        for (light, number) in self.lights.iter_mut().zip(0..) {
            light.in_view = SurfaceFlags::in_view(number);
            unveil(light, &mut self.objects);
        }
        PreparedScene {
            sights: LightCones {
                all: self.sights.as_flattened(),
                count: self.finite.len(),
            },
            finite: &self.finite,
            groups: &self.groups,
            endless: &self.endless,
            settings: Settings {
                is_opaque: self.materials.iter().all(|material| material.kt.is_black()),
                ..settings
            },
            objects: &self.objects,
            lights: &self.lights,
            materials: &self.materials,
        }
    }
}

impl<const OBJECTS: usize, const LIGHTS: usize, const MATERIALS: usize> SceneSink
    for SceneBuffer<OBJECTS, LIGHTS, MATERIALS>
{
    fn clear(&mut self) {
        self.objects.clear();
        self.lights.clear();
        self.materials.clear();
    }

    fn push_object(&mut self, object: Object) -> Result<(), CapacityError> {
        self.objects
            .push(object)
            .map_err(|_| CapacityError::new("objects", OBJECTS))
    }

    fn push_light(&mut self, light: Light) -> Result<(), CapacityError> {
        self.lights
            .push(light)
            .map_err(|_| CapacityError::new("lights", LIGHTS))
    }

    fn push_material(&mut self, material: Material) -> Result<(), CapacityError> {
        self.materials
            .push(material.complete())
            .map_err(|_| CapacityError::new("materials", MATERIALS))
    }
}

impl PreparedScene<'_> {
    /// Moves the camera, all else left as it is: a fraction of the work of
    /// preparing, also for a scene that was decoded.
    ///
    /// Preparing the scene with this camera draws the same picture, bit for bit,
    /// as long as it finds the same scale; else positions are rounded
    /// differently, by 2^-28 of the scene. The eye has room to orbit: it may go
    /// 3.5 times as far from the middle of the scene, in each coordinate, as
    /// anything finite, the first eye and the lights included, lies from it.
    ///
    /// ```
    /// use whitted::{Camera, Material, MaterialId, Object, Real, Scene, SceneBuffer, Vec3};
    ///
    /// let camera = Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33"));
    /// let mut buffer = SceneBuffer::<8, 2, 8>::new();
    /// let mut scene = buffer.prepare(&Scene {
    ///     materials: &[Material::BLACK],
    ///     objects: &[Object::sphere(Vec3::lit("0", "1", "0"), Real::ONE, MaterialId(0))],
    ///     ..Scene::new(camera)
    /// })?;
    /// for _ in 0..36 {
    ///     scene.set_camera(&scene.camera().orbited(Real::lit("10"), Real::ZERO))?;
    ///     // Renderer::new(&scene, display.size()).draw(&mut display)
    /// }
    /// # Ok::<(), whitted::SceneError>(())
    /// ```
    ///
    /// # Errors
    /// What [`SceneBuffer::prepare`] says of a camera, and
    /// [`SceneProblem::OutOfReach`](crate::Problem::OutOfReach) where its eye is too
    /// far away. The camera then stays where it was.
    pub fn set_camera(&mut self, camera: &Camera) -> Result<(), SceneError> {
        self.settings.camera = prepare::moved_camera(camera, &self.settings.frame)?;
        self.settings.authored = *camera;
        Ok(())
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
        codec::encoded_len(self)
    }

    /// Writes the scene as bytes that [`SceneBuffer::decode`] reads, and says
    /// how many; `None` if `out` is too short.
    ///
    /// All integers are little-endian and already scaled. The bytes begin with
    /// a version and end with a CRC-32.
    pub fn encode(&self, out: &mut [u8]) -> Option<usize> {
        codec::encode(self, out)
    }
}

/// The type of a [`SceneBuffer`] with the capacity of a constant
/// [`SceneCounts`](crate::scene::SceneCounts).
///
/// ```
/// use whitted::scene::SceneCounts;
///
/// const COUNTS: SceneCounts = SceneCounts::EMPTY.objects(8).lights(2).materials(8);
/// let buffer = <whitted::scene_buffer!(COUNTS)>::new();
/// # let _ = buffer;
/// ```
#[macro_export]
macro_rules! scene_buffer {
    ($counts:path) => {
        $crate::SceneBuffer<{ $counts.objects }, { $counts.lights }, { $counts.materials }>
    };
}
