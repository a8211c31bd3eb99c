//! Checks that validate an authored scene and do not depend on its scale.

use super::settings::MAX_DEPTH;
use crate::geometry;
use crate::geometry::limits;
use crate::math::{Color, Factor, Real, factor};
use crate::scene::{
    Background, Camera, Light, Material, MaterialId, Object, Scene, SceneError, SceneItem,
    SceneProblem, Texture,
};

/// Greatest value of a color channel of a light, an emission, the ambient light or the
/// background.
const BRIGHTEST: Real = Real::lit("256");

#[inline(never)]
fn color(
    item: SceneItem,
    field: &'static str,
    color: Color<Real>,
    most: Real,
) -> Result<(), SceneError> {
    [color.r, color.g, color.b]
        .into_iter()
        .try_for_each(|c| limits::range(item, field, c, [Real::ZERO, most]))
}

/// Runs all checks that do not depend on the scale of the scene.
pub(crate) fn scene(scene: &Scene<'_>) -> Result<(), SceneError> {
    max_depth(scene.max_depth)?;
    min_weight(scene.min_weight)?;
    color(SceneItem::Scene, "ambient", scene.ambient, BRIGHTEST)?;
    match scene.background {
        Background::Solid(solid) => color(SceneItem::Scene, "background", solid, BRIGHTEST)?,
        Background::Gradient { horizon, zenith } => {
            color(SceneItem::Scene, "background.horizon", horizon, BRIGHTEST)?;
            color(SceneItem::Scene, "background.zenith", zenith, BRIGHTEST)?;
        }
    }
    camera(&scene.camera)?;
    countable("lights", scene.lights.len())?;
    countable("materials", scene.materials.len())?;
    countable("objects", scene.objects.len())?;
    for (it, index) in scene.lights.iter().zip(0..) {
        light(SceneItem::Light(index), it)?;
    }
    for (it, index) in scene.materials.iter().zip(0..) {
        material(SceneItem::Material(index), it)?;
    }
    for (it, index) in scene.objects.iter().zip(0..) {
        object(SceneItem::Object(index), it, scene.materials.len())?;
    }
    Ok(())
}

/// Checks that a list is not longer than 16-bit indices allow.
fn countable(list: &'static str, length: usize) -> Result<(), SceneError> {
    let capacity = u16::MAX;
    if length > usize::from(capacity) {
        return limits::error(SceneItem::Scene, list, SceneProblem::TooMany { capacity });
    }
    Ok(())
}

pub(crate) fn max_depth(max_depth: u8) -> Result<u8, SceneError> {
    limits::range(
        SceneItem::Scene,
        "max_depth",
        max_depth.into(),
        [Real::ZERO, MAX_DEPTH.into()],
    )?;
    Ok(max_depth)
}

pub(crate) fn min_weight(min_weight: Real) -> Result<Factor, SceneError> {
    limits::range(
        SceneItem::Scene,
        "min_weight",
        min_weight,
        [Real::ZERO, Real::ONE],
    )?;
    Ok(factor(min_weight, 0))
}

pub(crate) fn camera(camera: &Camera) -> Result<(), SceneError> {
    let item = SceneItem::Camera;
    limits::point(item, "eye", camera.eye)?;
    limits::point(item, "look_at", camera.look_at)?;
    limits::point(item, "up", camera.up)?;
    limits::range(
        item,
        "fovy_deg",
        camera.fovy_deg,
        const { [Real::lit("1"), Real::lit("170")] },
    )
}

pub(crate) fn light(item: SceneItem, light: &Light) -> Result<(), SceneError> {
    limits::point(item, "position", light.position)?;
    color(item, "diffuse", light.diffuse, BRIGHTEST)?;
    color(item, "specular", light.specular, BRIGHTEST)
}

fn material(item: SceneItem, material: &Material) -> Result<(), SceneError> {
    for (field, coefficient) in [
        ("ka", material.ka),
        ("kd", material.kd),
        ("ks", material.ks),
        ("kr", material.kr),
        ("kt", material.kt),
    ] {
        color(item, field, coefficient, Real::ONE)?;
    }
    color(item, "le", material.le, BRIGHTEST)?;
    let black = Color::gray(Real::ZERO);
    if material.kt != black && cfg!(not(feature = "glass")) {
        return limits::error(item, "kt", SceneProblem::MissingFeature("glass"));
    }
    if material.ks != black {
        limits::range(
            item,
            "shininess",
            material.shininess,
            const { [Real::ONE, Real::lit("4096")] },
        )?;
    }
    if material.kt != black {
        limits::range(
            item,
            "ior",
            material.ior,
            const { [Real::ONE, Real::lit("4")] },
        )?;
    }
    Ok(())
}

fn object(item: SceneItem, object: &Object, materials: usize) -> Result<(), SceneError> {
    geometry::validate(&object.shape, item)?;
    let known = |field, MaterialId(index)| {
        if usize::from(index) < materials {
            Ok(())
        } else {
            let count = materials as u16;
            limits::error(item, field, SceneProblem::NoSuchMaterial { index, count })
        }
    };
    match object.texture {
        Texture::Uniform(material) => known("material", material),
        Texture::Checker {
            size,
            axes: [first, second],
            materials,
        } => {
            limits::range(
                item,
                "checker.size",
                size,
                [limits::SMALLEST, limits::FARTHEST],
            )?;
            if first == second {
                return limits::error(item, "checker.axes", SceneProblem::SameAxis);
            }
            materials
                .into_iter()
                .try_for_each(|material| known("checker.materials", material))
        }
    }
}
