use heapless::Vec;

use crate::scene::{Camera, CapacityError, Light, Material, MaterialId, Object, Scene, SceneError};

/// Builds a scene at run time, without allocation.
///
/// The builder has room for `OBJECTS` objects, `LIGHTS` lights and `MATERIALS` materials. It takes
/// 144 bytes per object, 72 bytes per light and 168 bytes per material.
///
/// ```
/// use whitted::{Camera, Color, Light, Material, Object, Real, color, real, vec3};
/// use whitted::scene::SceneBuilder;
///
/// let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
/// let mut builder = SceneBuilder::<4, 1, 2>::new(camera);
/// let red = builder.material(Material { kd: color!(0.6, 0.04, 0.03), ..Material::BLACK })?;
/// builder.light(Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE)))?;
/// builder.object(Object::sphere(vec3!(0, 1, 0), Real::ONE, red))?;
/// builder.settings.max_depth = 2;
/// assert_eq!(builder.scene().objects.len(), 1);
/// # Ok::<(), whitted::SceneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SceneBuilder<const OBJECTS: usize, const LIGHTS: usize, const MATERIALS: usize> {
    /// The camera, ambient light, background and limits of the scene. The lists of objects, lights
    /// and materials in `settings` are ignored.
    pub settings: Scene<'static>,
    objects: Vec<Object, OBJECTS>,
    lights: Vec<Light, LIGHTS>,
    materials: Vec<Material, MATERIALS>,
}

impl<const OBJECTS: usize, const LIGHTS: usize, const MATERIALS: usize>
    SceneBuilder<OBJECTS, LIGHTS, MATERIALS>
{
    /// Returns an empty builder. Its settings are those of [`Scene::new`].
    pub const fn new(camera: Camera) -> Self {
        Self {
            settings: Scene::new(camera),
            objects: Vec::new(),
            lights: Vec::new(),
            materials: Vec::new(),
        }
    }

    /// Adds a material. Returns its number, which objects use to refer to the material.
    ///
    /// # Errors
    /// Returns [`SceneProblem::TooMany`](crate::scene::SceneProblem::TooMany) if the builder
    /// already has `MATERIALS` materials.
    pub fn material(&mut self, material: Material) -> Result<MaterialId, SceneError> {
        let id = MaterialId(self.materials.len() as u16);
        self.materials
            .push(material)
            .map_err(|_| CapacityError::new("materials", MATERIALS))?;
        Ok(id)
    }

    /// Adds a light.
    ///
    /// # Errors
    /// Returns [`SceneProblem::TooMany`](crate::scene::SceneProblem::TooMany) if the builder
    /// already has `LIGHTS` lights.
    pub fn light(&mut self, light: Light) -> Result<(), SceneError> {
        self.lights
            .push(light)
            .map_err(|_| CapacityError::new("lights", LIGHTS).into())
    }

    /// Adds an object and returns its index.
    ///
    /// # Errors
    /// Returns [`SceneProblem::TooMany`](crate::scene::SceneProblem::TooMany) if the builder
    /// already has `OBJECTS` objects.
    pub fn object(&mut self, object: Object) -> Result<usize, SceneError> {
        let index = self.objects.len();
        self.objects
            .push(object)
            .map_err(|_| CapacityError::new("objects", OBJECTS))?;
        Ok(index)
    }

    /// Returns the objects, so that a program can change them between frames.
    pub fn objects_mut(&mut self) -> &mut [Object] {
        &mut self.objects
    }

    /// Returns the lights, so that a program can change them between frames.
    pub fn lights_mut(&mut self) -> &mut [Light] {
        &mut self.lights
    }

    /// Returns the scene that was built. The scene borrows the lists of the builder.
    pub fn scene(&self) -> Scene<'_> {
        Scene {
            objects: &self.objects,
            lights: &self.lights,
            materials: &self.materials,
            ..self.settings
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_have_documented_sizes() {
        assert_eq!(size_of::<Object>(), 144);
        assert_eq!(size_of::<Light>(), 72);
        assert_eq!(size_of::<Material>(), 168);
    }
}
