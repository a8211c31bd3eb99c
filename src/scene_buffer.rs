use heapless::Vec;

#[cfg(feature = "animation")]
use crate::animation::{self, Animation, AnimationError, PreparedAnimation};
use crate::geometry::{CullSphere, LightCone};
use crate::prepare::{Light, Material, Object, PreparedScene, SceneLists, SceneSink, Settings};
use crate::scene::{CapacityError, DecodeError, Scene, SceneError};
use crate::{codec, prepare};

/// Memory for a prepared scene, with a fixed capacity for objects, lights and materials. The
/// buffer may be in a `static` or on the stack.
///
/// An object takes 112 bytes, plus 34 bytes for its bounds and 12 bytes for each light of the
/// buffer. A light takes 28 bytes, and a material takes 68 bytes. The macro
/// [`scene_buffer!`](crate::scene_buffer!) returns the type of a buffer that has the counts of a
/// scene as its capacities.
///
/// ```
/// use whitted::{Camera, Scene, SceneBuffer, real, vec3};
///
/// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
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
    bounded: Vec<CullSphere, OBJECTS>,
    groups: Vec<CullSphere, OBJECTS>,
    unbounded: Vec<u16, OBJECTS>,
    light_cones: [[LightCone; OBJECTS]; LIGHTS],
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
    /// Returns an empty buffer.
    pub const fn new() -> Self {
        Self {
            objects: Vec::new(),
            lights: Vec::new(),
            materials: Vec::new(),
            bounded: Vec::new(),
            groups: Vec::new(),
            unbounded: Vec::new(),
            light_cones: [[LightCone::FULL; OBJECTS]; LIGHTS],
        }
    }

    /// Validates a scene and prepares it for tracing. Preparing uses only integer arithmetic,
    /// so the result is the same on every target.
    ///
    /// # Errors
    /// Returns an error that names the first item that cannot be rendered, its field, and the
    /// problem.
    pub fn prepare<'b>(&'b mut self, scene: &Scene<'b>) -> Result<PreparedScene<'b>, SceneError> {
        let settings = prepare::prepare(scene, self)?;
        Ok(self.finish(settings))
    }

    /// Decodes a compiled scene that [`PreparedScene::encode`] wrote. If the scene is animated,
    /// returns the scene before animation.
    ///
    /// # Errors
    /// Returns an error if the bytes are not a valid compiled scene, or if the scene exceeds
    /// the capacity of the buffer. After an error, the buffer is empty.
    pub fn decode<'b>(&'b mut self, bytes: &'b [u8]) -> Result<PreparedScene<'b>, DecodeError> {
        let decoded = codec::decode(bytes, self);
        if decoded.is_err() {
            self.clear();
        }
        let (settings, _) = decoded?;
        Ok(self.finish(settings))
    }

    /// Validates a scene and its animation, and prepares both. All frames have the same scale,
    /// which fits everything that the tracks reach.
    ///
    /// # Errors
    /// Returns an error for the first track that cannot be played, and its keyframe. If the scene
    /// before animation cannot be prepared, returns this error.
    #[cfg(feature = "animation")]
    pub fn prepare_animation<'b>(
        &'b mut self,
        scene: &Scene<'b>,
        animation: &Animation<'b>,
    ) -> Result<PreparedAnimation<'b>, AnimationError> {
        let (settings, script) = animation::prepare(scene, animation, self)?;
        Ok(PreparedAnimation::new(self.lists(), settings, script))
    }

    /// Decodes a compiled scene with its animation, which [`PreparedAnimation::encode`] wrote. If
    /// the scene has no animation, all frames are equal.
    ///
    /// The animation borrows the bytes, because it reads its keyframes from them.
    ///
    /// # Errors
    /// Returns an error if the bytes are not a valid compiled scene, or if the scene exceeds
    /// the capacity of the buffer. After an error, the buffer is empty.
    #[cfg(feature = "animation")]
    pub fn decode_animation<'b>(
        &'b mut self,
        bytes: &'b [u8],
    ) -> Result<PreparedAnimation<'b>, DecodeError> {
        let decoded = animation::decode(bytes, self);
        if decoded.is_err() {
            self.clear();
        }
        let (settings, script) = decoded?;
        Ok(PreparedAnimation::new(self.lists(), settings, script))
    }

    fn finish(&mut self, settings: Settings) -> PreparedScene<'_> {
        PreparedScene::new(self.lists(), settings)
    }

    fn lists(&mut self) -> SceneLists<'_> {
        SceneLists {
            objects: &mut self.objects,
            lights: &mut self.lights,
            materials: &self.materials,
            bounded: self.bounded.as_mut_view(),
            groups: self.groups.as_mut_view(),
            unbounded: self.unbounded.as_mut_view(),
            light_cones: self.light_cones.as_flattened_mut(),
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
            .push(material)
            .map_err(|_| CapacityError::new("materials", MATERIALS))
    }
}

/// Returns the type of the [`SceneBuffer`] that has the capacities given by a constant
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
