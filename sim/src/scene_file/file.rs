use whitted::{Light, Material, MaterialId, Object, PreparedScene, Scene, SceneBuffer, Texture};

use super::error::LoadError;
use super::motion::Motion;
use super::outline::Outline;

/// Room for any scene a person would write by hand.
pub type Buffer = SceneBuffer<256, 16, 256>;

/// A scene file's content, with lists of its own.
#[derive(Clone, Debug)]
pub struct SceneFile {
    /// What the file calls the scene.
    pub title: Option<String>,
    /// All but the lists, which are empty here.
    pub settings: Scene<'static>,
    /// The lights, in the file's order.
    pub lights: Vec<Light>,
    /// The materials, in the file's order: a `MaterialId` counts them from 0.
    pub materials: Vec<Material>,
    /// What the file calls the materials, in the same order.
    pub material_names: Vec<String>,
    /// The objects, in the file's order.
    pub objects: Vec<Object>,
    /// How the scene moves, if it does.
    pub animation: Option<Motion>,
    pub(super) outline: Outline,
}

impl SceneFile {
    /// The scene, to be prepared.
    pub fn scene(&self) -> Scene<'_> {
        Scene {
            lights: &self.lights,
            materials: &self.materials,
            objects: &self.objects,
            ..self.settings
        }
    }

    /// Prepares the scene; what is wrong with a value is explained by its line.
    pub fn prepare<'b>(&'b self, buffer: &'b mut Buffer) -> Result<PreparedScene<'b>, LoadError> {
        buffer
            .prepare(&self.scene())
            .map_err(|error| self.explain(error))
    }
    /// An object in the file's words: its type and what covers it, for example
    /// `sphere "glass"`.
    pub fn describe(&self, object: u16) -> Option<String> {
        let name = |MaterialId(index)| self.material_names.get(usize::from(index));
        let kind = self.outline.find(&format!("objects[{object}].type"))?;
        let kind = kind.text.trim_matches(['"', '\'']);
        Some(match self.objects.get(usize::from(object))?.texture {
            Texture::Uniform(material) => format!("{kind} {:?}", name(material)?),
            Texture::Checker {
                materials: [even, odd],
                ..
            } => format!("{kind} {:?} or {:?}", name(even)?, name(odd)?),
        })
    }
}
