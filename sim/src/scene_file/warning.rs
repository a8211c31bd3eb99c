//! Warnings about scenes that can be rendered but look black or odd.

use embedded_graphics_core::geometry::Size;
use whitted::animation::Target;
use whitted::observer::{Observer, RayNode};
use whitted::{Color, Light, Material, MaterialId, PreparedScene, Real, Renderer, Shape, Texture};

use super::error::LoadError;
use super::file::SceneFile;
use super::inside::is_inside;

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
        } else if !self.is_eye_animated() && !sees_object(prepared) {
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

    fn warn_about_lights(&self, warnings: &mut Vec<LoadError>) {
        let needs_light = |material: &Material| material.kd != BLACK || material.ks != BLACK;
        let mut used = (0..).zip(&self.materials).filter(|it| self.is_used(it.0));
        if self.lights.is_empty() && used.any(|(_, material)| needs_light(material)) {
            let reason = "the scene has no lights, so `kd` and `ks` have no effect";
            warnings.push(self.warning("lights", reason, "add a light under [[lights]]"));
        }
        for (index, light) in (0..).zip(&self.lights) {
            let is_black = [light.diffuse, light.specular] == [BLACK; 2];
            if is_black && !self.is_animated(Target::LightColor(index)) {
                let key = format!("lights[{index}].color");
                let help = "write for example `color = [1.0, 1.0, 1.0]`";
                warnings.push(self.warning(&key, "is black, so the light has no effect", help));
            }
            warnings.extend(self.hidden_light(index, light));
        }
    }

    /// Returns a warning if a light is inside an opaque object and the eye is outside.
    fn hidden_light(&self, index: u16, light: &Light) -> Option<LoadError> {
        if self.is_animated(Target::LightPosition(index)) || self.is_eye_animated() {
            return None;
        }
        let eye = self.settings.camera.eye;
        let around = self
            .opaque_objects()
            .find(|(_, shape)| is_inside(shape, light.position) && !is_inside(shape, eye));
        let key = format!("lights[{index}].position");
        let (object, _) = around?;
        let reason = format!("is inside the opaque object {object}, so its light is not visible");
        Some(self.warning(&key, &reason, "move the light, or give the object `kt`"))
    }

    /// Warns if the eye is inside an opaque object that has no light inside.
    fn warn_about_eye(&self, warnings: &mut Vec<LoadError>) {
        let eye = self.settings.camera.eye;
        let is_dark = |shape| {
            let mut lights = self.lights.iter();
            is_inside(shape, eye) && !lights.any(|light| is_inside(shape, light.position))
        };
        let is_any_light_animated =
            (0..16).any(|light| self.is_animated(Target::LightPosition(light)));
        if self.is_eye_animated() || is_any_light_animated {
            return;
        }
        if let Some((object, _)) = self.opaque_objects().find(|(_, shape)| is_dark(shape)) {
            let reason = format!("is inside the opaque object {object}, without a light");
            let help = "move the eye, or move a light into the object";
            warnings.push(self.warning("camera.eye", &reason, help));
        }
    }

    /// Returns the objects that transmit no light and do not move, with their numbers.
    fn opaque_objects(&self) -> impl Iterator<Item = (u16, &Shape)> {
        let is_opaque = |MaterialId(index): MaterialId| {
            let material = self.materials.get(usize::from(index));
            material.is_some_and(|material| material.kt == BLACK)
        };
        (0..)
            .zip(&self.objects)
            .filter(move |(index, object)| {
                materials(&object.texture).iter().all(|it| is_opaque(*it))
                    && !self.is_animated(Target::ObjectPosition(*index))
                    && !self.is_animated(Target::ObjectRadius(*index))
            })
            .map(|(index, object)| (index, &object.shape))
    }

    fn is_used(&self, material: usize) -> bool {
        let mut textures = self.objects.iter().map(|object| materials(&object.texture));
        textures.any(|used| {
            used.iter()
                .any(|MaterialId(it)| usize::from(*it) == material)
        })
    }

    fn is_animated(&self, target: Target) -> bool {
        let tracks = self.animation.iter().flat_map(|it| &it.tracks);
        tracks.into_iter().any(|track| track.target == target)
    }

    fn is_eye_animated(&self) -> bool {
        self.is_animated(Target::CameraEye)
            || self.is_animated(Target::CameraOrbit)
            || self.is_animated(Target::CameraLookAt)
    }

    fn warning(&self, key: &str, reason: &str, help: &str) -> LoadError {
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

/// Returns the materials of a texture.
fn materials(texture: &Texture) -> [MaterialId; 2] {
    match *texture {
        Texture::Uniform(material) => [material; 2],
        Texture::Checker { materials, .. } => materials,
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
