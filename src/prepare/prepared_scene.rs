use core::fmt;

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

/// Receives the objects, lights and materials of a scene while the scene is prepared or decoded.
///
/// The functions that prepare and decode a scene take a `SceneSink` instead of a buffer. The
/// functions are therefore compiled only once, and not once for each capacity of a buffer.
pub(crate) trait SceneSink {
    fn clear(&mut self);
    fn push_object(&mut self, object: Object) -> Result<(), CapacityError>;
    fn push_light(&mut self, light: Light) -> Result<(), CapacityError>;
    fn push_material(&mut self, material: Material) -> Result<(), CapacityError>;
}

/// The objects, lights and materials of a scene, and memory for the data that culling computes.
pub(crate) struct SceneLists<'b> {
    pub(crate) objects: &'b mut [Object],
    pub(crate) lights: &'b mut [Light],
    pub(crate) materials: &'b [Material],
    /// List with one entry for each bounded object.
    pub(crate) bounded: &'b mut VecView<CullSphere>,
    /// List with one entry for each group of bounded objects.
    pub(crate) groups: &'b mut VecView<CullSphere>,
    /// List with one entry for each unbounded object.
    pub(crate) unbounded: &'b mut VecView<u16>,
    /// List with one entry for each pair of a light and a bounded object.
    pub(crate) light_cones: &'b mut [LightCone],
}

impl SceneLists<'_> {
    /// Returns lists that borrow these lists.
    pub(crate) fn reborrow(&mut self) -> SceneLists<'_> {
        SceneLists {
            objects: self.objects,
            lights: self.lights,
            materials: self.materials,
            bounded: self.bounded,
            groups: self.groups,
            unbounded: self.unbounded,
            light_cones: self.light_cones,
        }
    }
}

/// A scene that is ready to be rendered, in the memory of a
/// [`SceneBuffer`](crate::SceneBuffer).
#[derive(Clone, Copy)]
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
    /// Cones around the bounded objects. The cones that start at the first light come first,
    /// then those of the second light, and so on.
    light_cones: &'b [LightCone],
}

/// Writes one line with the numbers of objects, lights and materials.
impl fmt::Debug for PreparedScene<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let SceneCounts {
            objects,
            lights,
            materials,
        } = self.counts();
        write!(
            f,
            "PreparedScene {{ objects: {objects}, lights: {lights}, materials: {materials} }}"
        )
    }
}

impl<'b> PreparedScene<'b> {
    /// Returns a prepared scene and computes its culling data. `lists` must contain all objects,
    /// lights and materials of the scene.
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
        // An earlier frame of an animation may have set flags that no longer hold.
        for object in objects.iter_mut() {
            object.flags = object.shape.flags();
        }
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

    /// Returns the maximum number of generations of secondary rays.
    pub fn max_depth(&self) -> u8 {
        self.settings.max_depth
    }

    /// Returns the transfer function with which renderers of the scene start.
    pub fn transfer(&self) -> scene::Transfer {
        self.settings.transfer.unwrap_or_default()
    }

    /// Returns the camera, in world units.
    pub fn camera(&self) -> scene::Camera {
        self.settings.authored_camera
    }

    /// Returns the numbers of objects, lights and materials.
    pub fn counts(&self) -> SceneCounts {
        SceneCounts::EMPTY
            .objects(self.objects.len())
            .lights(self.lights.len())
            .materials(self.materials.len())
    }

    /// Replaces the camera and keeps everything else in the scene. This is much faster than
    /// preparing the scene again. It also works for a decoded scene.
    ///
    /// The picture is usually the same, bit for bit, as if the scene were prepared again with
    /// the new camera. The picture differs only if the new camera would change the scale of the
    /// scene. Another scale rounds positions differently, by 2^-28 of the size of the scene.
    ///
    /// The new eye may be farther from the center of the scene than the old eye, so there is
    /// room to orbit. Let `d` be the greatest distance, in any coordinate, of a bounded object,
    /// a light or the first eye from the center. In each coordinate, the new eye may be `3.5 d`
    /// away from the center.
    ///
    /// ```
    /// use whitted::{Camera, Material, MaterialId, Object, Real, Scene, SceneBuffer, real, vec3};
    ///
    /// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
    /// let scene = Scene {
    ///     materials: &[Material::BLACK],
    ///     objects: &[Object::sphere(vec3!(0, 1, 0), Real::ONE, MaterialId(0))],
    ///     ..Scene::new(camera)
    /// };
    /// let mut buffer = SceneBuffer::<8, 2, 8>::new();
    /// let mut scene = buffer.prepare(&scene)?;
    /// for _ in 0..36 {
    ///     scene.set_camera(&scene.camera().orbited(real!(10), Real::ZERO))?;
    ///     // Renderer::new(&scene, display.size()).draw(&mut display)
    /// }
    /// # Ok::<(), whitted::SceneError>(())
    /// ```
    ///
    /// # Errors
    /// Returns the errors of [`SceneBuffer::prepare`](crate::SceneBuffer::prepare) about a
    /// camera, and [`SceneProblem::OutOfReach`](crate::scene::SceneProblem::OutOfReach) if the
    /// eye is too far from the center of the scene. After an error, the previous camera stays
    /// in place.
    pub fn set_camera(&mut self, camera: &scene::Camera) -> Result<(), SceneError> {
        self.settings.camera = camera::moved_camera(camera, &self.settings.normalization)?;
        self.settings.authored_camera = *camera;
        Ok(())
    }

    /// Sets the maximum number of generations of secondary rays.
    ///
    /// # Errors
    /// Returns an error if `max_depth` is above 32.
    pub fn set_max_depth(&mut self, max_depth: u8) -> Result<(), SceneError> {
        self.settings.max_depth = validate::max_depth(max_depth)?;
        Ok(())
    }

    /// Sets the minimum weight of a secondary ray. The renderer does not trace secondary rays
    /// that have a smaller weight.
    ///
    /// # Errors
    /// Returns an error if `min_weight` is outside the range from 0 to 1.
    pub fn set_min_weight(&mut self, min_weight: Real) -> Result<(), SceneError> {
        self.settings.min_weight = validate::min_weight(min_weight)?;
        Ok(())
    }

    /// Returns the material at an index. The material indices of all objects are valid, because
    /// preparing and decoding check them.
    pub(crate) fn material(&self, index: u16) -> &'b Material {
        static BLACK: Material = Material::BLACK;
        self.materials.get(usize::from(index)).unwrap_or(&BLACK)
    }

    /// Returns the object at an index. `index` must be the index of an object that a ray hit.
    pub(crate) fn object(&self, index: u16) -> &'b Object {
        static NONE: Object = Object::NONE;
        self.objects.get(usize::from(index)).unwrap_or(&NONE)
    }

    /// Returns the cones that start at a light and enclose the bounded objects.
    pub(crate) fn light_cones(&self, light: usize) -> &'b [LightCone] {
        let count = self.bounded.len();
        let first = light * count;
        self.light_cones
            .get(first..first + count)
            .unwrap_or_default()
    }

    /// Returns the transmittance of an object at a point of its surface.
    #[inline(never)]
    pub(crate) fn transmittance(&self, object: &Object, point: &Point) -> Color<Factor> {
        self.material(object.texture.material(point)).kt.narrowed()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks the memory figures in the documentation of [`SceneBuffer`](crate::SceneBuffer).
    #[test]
    fn items_take_the_documented_memory() {
        assert_eq!(size_of::<Object>(), 112);
        assert_eq!(size_of::<CullSphere>(), 16);
        assert_eq!(size_of::<LightCone>(), 12);
        assert_eq!(size_of::<Light>(), 28);
        assert_eq!(size_of::<Material>(), 68);
    }
}
