use heapless::VecView;

use super::light::Light;
use super::material::Material;
use super::object::Object;
use super::settings::Settings;
use super::{camera, culling, validate};
use crate::geometry::{CullSphere, LightCone, Point};
use crate::math::{Color, Factor, Real};
use crate::scene;
use crate::scene::{CapacityError, SceneCounts, SceneError};

/// Receives the items of a scene while it is prepared or decoded.
///
/// Preparing and decoding take a `SceneSink`, so they are compiled once and not once per
/// capacity of a buffer.
pub(crate) trait SceneSink {
    fn clear(&mut self);
    fn push_object(&mut self, object: Object) -> Result<(), CapacityError>;
    fn push_light(&mut self, light: Light) -> Result<(), CapacityError>;
    fn push_material(&mut self, material: Material) -> Result<(), CapacityError>;
}

/// The items of a scene, and memory for the data that culling derives from them.
pub(crate) struct SceneLists<'b> {
    pub(crate) objects: &'b mut [Object],
    pub(crate) lights: &'b mut [Light],
    pub(crate) materials: &'b [Material],
    /// One entry per bounded object.
    pub(crate) bounded: &'b mut VecView<CullSphere>,
    /// One entry per group of bounded objects.
    pub(crate) groups: &'b mut VecView<CullSphere>,
    /// One entry per unbounded object.
    pub(crate) unbounded: &'b mut VecView<u16>,
    /// One entry per light and bounded object.
    pub(crate) light_cones: &'b mut [LightCone],
}

/// A scene that is ready to be rendered, in the memory of a
/// [`SceneBuffer`](crate::SceneBuffer).
#[derive(Clone, Copy, Debug)]
pub struct PreparedScene<'b> {
    pub(crate) settings: Settings,
    pub(crate) objects: &'b [Object],
    pub(crate) lights: &'b [Light],
    pub(crate) materials: &'b [Material],
    /// Bounding spheres of the bounded objects.
    pub(crate) bounded: &'b [CullSphere],
    /// Bounding spheres of groups of neighboring bounded objects.
    pub(crate) groups: &'b [CullSphere],
    /// Indices of the unbounded objects.
    pub(crate) unbounded: &'b [u16],
    /// Light after light, the cones of the bounded objects.
    light_cones: &'b [LightCone],
}

impl<'b> PreparedScene<'b> {
    /// Computes the culling data of a scene whose items are complete.
    pub(crate) fn new(lists: SceneLists<'b>, settings: Settings) -> Self {
        let SceneLists {
            objects,
            lights,
            materials,
            bounded,
            groups,
            unbounded,
            light_cones,
        } = lists;
        culling::list_objects(objects, bounded, groups, unbounded);
        culling::mark_isolated(objects, materials);
        culling::build_light_cones(lights, objects, unbounded, light_cones);
        culling::mark_unoccluded(lights, objects);
        Self {
            settings: Settings {
                is_opaque: materials.iter().all(|material| material.kt.is_black()),
                ..settings
            },
            objects,
            lights,
            materials,
            bounded,
            groups,
            unbounded,
            light_cones,
        }
    }

    /// Maximum number of secondary generations of rays.
    pub fn max_depth(&self) -> u8 {
        self.settings.max_depth
    }

    /// The camera, in world units.
    pub fn camera(&self) -> scene::Camera {
        self.settings.authored_camera
    }

    /// Numbers of objects, lights and materials.
    pub fn counts(&self) -> SceneCounts {
        SceneCounts::EMPTY
            .objects(self.objects.len())
            .lights(self.lights.len())
            .materials(self.materials.len())
    }

    /// Moves the camera and keeps everything else: a fraction of the work of preparing, also
    /// for a decoded scene.
    ///
    /// Preparing the scene with this camera draws the same picture, bit for bit, if it finds
    /// the same scale; otherwise positions are rounded differently, by 2^-28 of the size of
    /// the scene. The eye may go 3.5 times as far from the center of the scene, in each
    /// coordinate, as any bounded object, the first eye and the lights, so there is room to
    /// orbit.
    ///
    /// ```
    /// use whitted::{Camera, Material, MaterialId, Object, Real, Scene, SceneBuffer, Vec3};
    ///
    /// let camera = Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33"));
    /// let scene = Scene {
    ///     materials: &[Material::BLACK],
    ///     objects: &[Object::sphere(Vec3::lit("0", "1", "0"), Real::ONE, MaterialId(0))],
    ///     ..Scene::new(camera)
    /// };
    /// let mut buffer = SceneBuffer::<8, 2, 8>::new();
    /// let mut scene = buffer.prepare(&scene)?;
    /// for _ in 0..36 {
    ///     scene.set_camera(&scene.camera().orbited(Real::lit("10"), Real::ZERO))?;
    ///     // Renderer::new(&scene, display.size()).draw(&mut display)
    /// }
    /// # Ok::<(), whitted::SceneError>(())
    /// ```
    ///
    /// # Errors
    /// The errors of [`SceneBuffer::prepare`](crate::SceneBuffer::prepare) about a camera, and
    /// [`SceneProblem::OutOfReach`](crate::scene::SceneProblem::OutOfReach) if the eye is too
    /// far away. The camera then keeps its place.
    pub fn set_camera(&mut self, camera: &scene::Camera) -> Result<(), SceneError> {
        self.settings.camera = camera::moved_camera(camera, &self.settings.normalization)?;
        self.settings.authored_camera = *camera;
        Ok(())
    }

    /// Sets the maximum number of secondary generations of rays.
    ///
    /// # Errors
    /// `max_depth` is above 32.
    pub fn set_max_depth(&mut self, max_depth: u8) -> Result<(), SceneError> {
        self.settings.max_depth = validate::max_depth(max_depth)?;
        Ok(())
    }

    /// Sets the weight below which a branch of the ray tree ends.
    ///
    /// # Errors
    /// `min_weight` is outside of 0 to 1.
    pub fn set_min_weight(&mut self, min_weight: Real) -> Result<(), SceneError> {
        self.settings.min_weight = validate::min_weight(min_weight)?;
        Ok(())
    }

    /// Material at an index. Preparing and decoding ensure that every index of an object is
    /// valid.
    #[inline(always)]
    pub(crate) fn material(&self, index: u16) -> &'b Material {
        static BLACK: Material = Material::BLACK;
        self.materials.get(usize::from(index)).unwrap_or(&BLACK)
    }

    /// Object at the index of a hit.
    #[inline(always)]
    pub(crate) fn object(&self, index: u16) -> &'b Object {
        static NONE: Object = Object::NONE;
        self.objects.get(usize::from(index)).unwrap_or(&NONE)
    }

    /// Cones of the bounded objects as seen from a light.
    #[inline(always)]
    pub(crate) fn light_cones(&self, light: usize) -> &'b [LightCone] {
        let count = self.bounded.len();
        let first = light * count;
        self.light_cones
            .get(first..first + count)
            .unwrap_or_default()
    }

    /// Transmittance of an object at a point of its surface.
    #[inline(never)]
    pub(crate) fn transmittance(&self, object: &Object, point: &Point) -> Color<Factor> {
        self.material(object.texture.material(point)).kt.narrowed()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks the figures in the documentation of [`SceneBuffer`](crate::SceneBuffer).
    #[test]
    fn items_take_the_documented_memory() {
        assert_eq!(size_of::<Object>(), 112);
        assert_eq!(size_of::<CullSphere>(), 16);
        assert_eq!(size_of::<LightCone>(), 12);
        assert_eq!(size_of::<Light>(), 28);
        assert_eq!(size_of::<Material>(), 68);
    }
}
