//! Warnings about scenes that can be rendered but look black or odd.

use embedded_graphics_core::geometry::Size;
use whitted::observer::{Observer, RayNode};
use whitted::{Color, Material, MaterialId, PreparedScene, Real, Renderer};

use super::error::LoadError;
use super::file::SceneFile;
use super::texture::materials_of;

const BLACK: Color<Real> = Color::gray(Real::ZERO);

impl SceneFile {
    /// Returns warnings about parts of the scene that have no effect, and about lights and cameras
    /// inside opaque objects.
    ///
    /// `prepared` is this scene.
    pub fn warnings(&self, prepared: &PreparedScene<'_>) -> Vec<LoadError> {
        let mut warnings = Vec::new();
        if self.objects.is_empty() {
            let reason = "the scene has no objects, so the picture shows the background only";
            warnings.push(self.warning("objects", reason, "add an object under [[objects]]"));
        } else if self.animation.is_none() && !sees_object(prepared) {
            let help = "move `eye`, `look_at` or an object";
            warnings.push(self.warning("camera", "sees no object", help));
        }
        self.warn_about_materials(&mut warnings);
        self.warn_about_lights(&mut warnings);
        self.warn_about_eye(&mut warnings);
        warnings
    }

    fn warn_about_materials(&self, warnings: &mut Vec<LoadError>) {
        for (index, (material, name)) in self.materials.iter().zip(&self.material_names).enumerate()
        {
            let key = |key| format!("materials.{name}{key}");
            if !self.is_used(index) {
                let help = "remove it, or name it as the `material` of an object";
                warnings.push(self.warning(&key(""), "is used by no object", help));
                continue;
            }
            if is_black(material) {
                let help = "add `kd = [0.6, 0.6, 0.6]`";
                warnings.push(self.warning(&key(""), "is black in any light", help));
            }
            let help = "set `max_depth` to at least 2";
            if material.kr != BLACK && self.settings.max_depth == 0 {
                let reason = "has no effect, because `max_depth` is 0";
                warnings.push(self.warning(&key(".kr"), reason, help));
            }
            if material.kt != BLACK && self.settings.max_depth < 2 {
                let reason =
                    "needs rays that enter and leave an object, but `max_depth` is below 2";
                warnings.push(self.warning(&key(".kt"), reason, help));
            }
        }
    }

    /// Returns true if an object has the material with this number.
    pub(super) fn is_used(&self, material: usize) -> bool {
        let mut textures = self
            .objects
            .iter()
            .map(|object| materials_of(&object.texture));
        textures.any(|used| {
            used.iter()
                .any(|MaterialId(it)| usize::from(*it) == material)
        })
    }

    pub(super) fn warning(&self, key: &str, reason: &str, help: &str) -> LoadError {
        self.error_at(key.to_owned(), reason).help(help)
    }
}

/// Returns true if the camera sees an object in a picture of 64x48 pixels.
fn sees_object(scene: &PreparedScene<'_>) -> bool {
    const SIZE: Size = Size::new(64, 48);
    let mut renderer = Renderer::with_observer(scene, SIZE, Hits(false));
    (0..SIZE.height).any(|y| {
        (0..SIZE.width).any(|x| {
            renderer.pixel(x, y);
            renderer.observer().0
        })
    })
}

/// Observer that notes that a ray has hit an object.
struct Hits(bool);

impl Observer for Hits {
    fn node(&mut self, node: &RayNode) {
        self.0 |= node.object.is_some();
    }
}

/// Returns true if all colors of a material are black.
fn is_black(material: &Material) -> bool {
    let Material {
        ka,
        kd,
        ks,
        kr,
        kt,
        le,
        ..
    } = *material;
    [ka, kd, ks, kr, kt, le] == [BLACK; 6]
}
