use heapless::Vec;

use crate::scene::{Camera, CapacityError, Light, Material, MaterialId, Object, Scene, SceneError};

/// A scene that is put together at run time, without allocation.
///
/// Room for `OBJECTS`, `LIGHTS` and `MATERIALS`; one more of them is an error
/// that says so. `settings` holds all that is not a list.
///
/// ```
/// use whitted::{Camera, Color, Light, Material, Object, Real, Vec3};
/// use whitted::scene::SceneBuilder;
///
/// let camera = Camera::new(Vec3::lit("0", "2", "8"), Vec3::lit("0", "1", "0"), Real::lit("33"));
/// let mut builder = SceneBuilder::<4, 1, 2>::new(camera);
/// let red = builder.material(Material { kd: Color::lit("0.6", "0.04", "0.03"), ..Material::BLACK })?;
/// builder.light(Light::point(Vec3::lit("-6", "11", "7"), Color::gray(Real::ONE)))?;
/// builder.object(Object::sphere(Vec3::lit("0", "1", "0"), Real::ONE, red))?;
/// builder.settings.max_depth = 2;
/// assert_eq!(builder.scene().objects.len(), 1);
/// # Ok::<(), whitted::SceneError>(())
/// ```
#[derive(Clone, Debug)]
pub struct SceneBuilder<const OBJECTS: usize, const LIGHTS: usize, const MATERIALS: usize> {
    /// Camera, ambient light, background, depth: all that is not a list. Its
    /// lists stay empty.
    pub settings: Scene<'static>,
    objects: Vec<Object, OBJECTS>,
    lights: Vec<Light, LIGHTS>,
    materials: Vec<Material, MATERIALS>,
}

impl<const OBJECTS: usize, const LIGHTS: usize, const MATERIALS: usize>
    SceneBuilder<OBJECTS, LIGHTS, MATERIALS>
{
    /// An empty scene with the settings of [`Scene::new`].
    pub const fn new(camera: Camera) -> Self {
        Self {
            settings: Scene::new(camera),
            objects: Vec::new(),
            lights: Vec::new(),
            materials: Vec::new(),
        }
    }

    /// Adds a material; objects name it by what comes back.
    ///
    /// # Errors
    ///
    /// There is no room left for it.
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
    ///
    /// There is no room left for it.
    pub fn light(&mut self, light: Light) -> Result<(), SceneError> {
        self.lights
            .push(light)
            .map_err(|_| CapacityError::new("lights", LIGHTS).into())
    }

    /// Adds an object; its number is how many were added before it.
    ///
    /// # Errors
    ///
    /// There is no room left for it.
    pub fn object(&mut self, object: Object) -> Result<usize, SceneError> {
        let index = self.objects.len();
        self.objects
            .push(object)
            .map_err(|_| CapacityError::new("objects", OBJECTS))?;
        Ok(index)
    }

    /// The objects so far, to be moved or changed between frames.
    pub fn objects_mut(&mut self) -> &mut [Object] {
        &mut self.objects
    }

    /// The lights so far, to be moved or changed between frames.
    pub fn lights_mut(&mut self) -> &mut [Light] {
        &mut self.lights
    }

    /// The scene, to be prepared.
    pub fn scene(&self) -> Scene<'_> {
        Scene {
            objects: &self.objects,
            lights: &self.lights,
            materials: &self.materials,
            ..self.settings
        }
    }
}
