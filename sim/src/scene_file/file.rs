use whitted::{Light, Material, MaterialId, Object, Scene, SceneBuffer, Texture};

use super::file_animation::FileAnimation;
use super::outline::Outline;
use crate::text::excerpt;

/// Largest number of objects of a scene file.
pub(super) const MAX_OBJECTS: usize = 256;
/// Largest number of lights of a scene file.
pub(super) const MAX_LIGHTS: usize = 16;
/// Largest number of materials of a scene file.
pub(super) const MAX_MATERIALS: usize = 256;

/// Scene buffer for scene files. Its capacity is 256 objects, 16 lights and 256 materials.
pub type Buffer = SceneBuffer<MAX_OBJECTS, MAX_LIGHTS, MAX_MATERIALS>;

/// Content of a scene file. This type owns its lists, while a [`Scene`] borrows its lists.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// Title of the scene.
    pub title: Option<String>,
    /// Comment at the top of the file, if it has one.
    pub comment: Option<String>,
    /// Camera and settings of the scene. The lists of lights, materials and objects in this
    /// [`Scene`] are empty.
    pub settings: Scene<'static>,
    /// Lights, in the file's order.
    pub lights: Vec<Light>,
    /// Materials, in the file's order. A `MaterialId` is an index into this list.
    pub materials: Vec<Material>,
    /// Names of the materials, in the order of `materials`.
    pub material_names: Vec<String>,
    /// Objects, in the file's order.
    pub objects: Vec<Object>,
    /// Animation of the scene, if it has one.
    pub animation: Option<FileAnimation>,
    pub(super) outline: Outline,
}

impl SceneFile {
    /// Returns the scene in the form that the library prepares.
    pub fn scene(&self) -> Scene<'_> {
        Scene {
            lights: &self.lights,
            materials: &self.materials,
            objects: &self.objects,
            ..self.settings
        }
    }

    /// Describes an object by its type and material, for example `sphere "glass"`.
    pub fn describe(&self, object: u16) -> Option<String> {
        let name = |MaterialId(index)| {
            let name = self.material_names.get(usize::from(index))?;
            Some(excerpt(name))
        };
        let kind = self.outline.find(&format!("objects[{object}].type"))?;
        let kind = kind.text.trim_matches(['"', '\'']);
        Some(match self.objects.get(usize::from(object))?.texture {
            Texture::Uniform(material) => format!("{kind} \"{}\"", name(material)?),
            Texture::Checker {
                materials: [even, odd],
                ..
            } => format!("{kind} \"{}\" or \"{}\"", name(even)?, name(odd)?),
        })
    }
}
