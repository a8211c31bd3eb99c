use whitted::animation::Target;
use whitted::{Color, Light, Material, MaterialId, Real, Shape};

use super::error::LoadError;
use super::file::SceneFile;
use super::inside::is_inside;
use super::texture::materials_of;

const BLACK: Color<Real> = Color::gray(Real::ZERO);

impl SceneFile {
    /// Warns about missing, black and hidden lights.
    pub(super) fn warn_about_lights(&self, warnings: &mut Vec<LoadError>) {
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
    pub(super) fn warn_about_eye(&self, warnings: &mut Vec<LoadError>) {
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
                materials_of(&object.texture)
                    .iter()
                    .all(|it| is_opaque(*it))
                    && !self.is_animated(Target::ObjectPosition(*index))
                    && !self.is_animated(Target::ObjectRadius(*index))
            })
            .map(|(index, object)| (index, &object.shape))
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
}
