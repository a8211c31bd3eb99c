//! Converts an authored scene to a prepared scene. The conversion validates the scene and
//! then normalizes its coordinates.
//!
//! Preparing a scene uses only integer arithmetic, so the result is the same on every target.
//! Checks that do not depend on the scale of the scene run first, for all items.

mod camera;
mod culling;
mod exposure;
mod light;
mod material;
mod normalize;
mod object;
mod prepared_scene;
mod settings;
mod texture;
mod validate;

pub use prepared_scene::PreparedScene;

pub(crate) use camera::moved_camera;
pub(crate) use culling::{GROUP, SMALL_SCENE};
pub(crate) use exposure::exposure;
pub(crate) use light::Light;
pub(crate) use material::Material;
pub(crate) use normalize::{extent, fit};
pub(crate) use object::Object;
pub(crate) use prepared_scene::{SceneLists, SceneSink};
pub(crate) use settings::{Camera, MAX_DEPTH, Settings};
pub(crate) use validate::{
    camera as validate_camera, light as validate_light, scene as validate_scene,
};

use crate::geometry::{Normalization, Shape};
use crate::math::{Color, Real, factor, radiance};
use crate::scene::{Background, Scene, SceneError, SceneItem};

/// Validates a scene, prepares its items and passes them to `sink`.
pub(crate) fn prepare(
    scene: &Scene<'_>,
    sink: &mut impl SceneSink,
) -> Result<Settings, SceneError> {
    sink.clear();
    validate::scene(scene)?;
    let normalization = normalize::fit(&normalize::extent(scene), scene.objects);
    let exposure = exposure::exposure(scene, |_, light| *light);
    prepare_scaled(scene, normalization, exposure, sink)
}

/// Prepares the items of a valid scene with a given scale and exposure, and passes them to `sink`.
pub(crate) fn prepare_scaled(
    scene: &Scene<'_>,
    normalization: Normalization,
    exposure: u8,
    sink: &mut impl SceneSink,
) -> Result<Settings, SceneError> {
    let camera = camera::camera(&scene.camera, &normalization)?;
    let intensity = |color: Color<Real>| color.map(|c| factor(c, exposure));
    for light in scene.lights {
        sink.push_light(Light {
            position: normalization.point(light.position),
            diffuse: intensity(light.diffuse),
            specular: intensity(light.specular),
            ..Light::default()
        })?;
    }
    for material in scene.materials {
        sink.push_material(Material::new(material, scene, exposure))?;
    }
    for (object, index) in scene.objects.iter().zip(0..) {
        let item = SceneItem::Object(index);
        sink.push_object(Object::new(
            Shape::prepare(&object.shape, &normalization, item)?,
            texture::texture(&object.texture, &normalization, item)?,
        ))?;
    }
    let (horizon, zenith) = match scene.background {
        Background::Solid(color) => (color, color),
        Background::Gradient { horizon, zenith } => (horizon, zenith),
    };
    let [horizon, zenith] = [horizon, zenith].map(|color| color.map(|c| radiance(c, exposure)));
    Ok(Settings {
        camera,
        authored_camera: scene.camera,
        normalization,
        horizon,
        zenith,
        is_gradient: horizon != zenith,
        exposure,
        max_depth: scene.max_depth,
        min_weight: factor(scene.min_weight, 0),
        transfer: Some(scene.transfer),
        is_opaque: false,
    })
}
