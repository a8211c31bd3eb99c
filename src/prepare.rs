//! From the authored scene to the prepared one: checks, then scales.
//!
//! Integer arithmetic alone, on the host as on the chip. Range checks come
//! first, over the whole scene; what is left to check then depends on the
//! scale.

pub(crate) mod culling;
mod prepared_scene;
mod shape;
mod validate;

pub use prepared_scene::PreparedScene;
pub(crate) use prepared_scene::{
    Camera, Light, LightCones, MAX_DEPTH, Material, Object, SceneSink, Settings,
};
pub(crate) use validate::{max_depth, min_weight};

use crate::geometry::{Checker, Normalization, Texture};
use crate::math::{Color, Length, Real, direction, factor, radiance, reciprocal, weight};
use crate::scene;
use crate::scene::{Axis, Background, Scene, SceneError, SceneItem, SceneProblem, SpecularModel};

use shape::shape;

/// Prepares a scene into `room`.
pub(crate) fn prepare(
    scene: &Scene<'_>,
    room: &mut impl SceneSink,
) -> Result<Settings, SceneError> {
    room.clear();
    validate::scene(scene)?;
    let frame = Normalization::new(scene);
    let exposure = exposure(scene);
    let camera = camera(&scene.camera, &frame)?;
    let intensity = |color: Color<Real>| color.map(|c| factor(c, exposure));
    for light in scene.lights {
        room.push_light(Light {
            position: frame.point(light.position),
            diffuse: intensity(light.diffuse),
            specular: intensity(light.specular),
            ..Light::default()
        })?;
    }
    for material in scene.materials {
        room.push_material(self::material(material, scene, exposure))?;
    }
    for (object, index) in scene.objects.iter().zip(0..) {
        room.push_object(Object::new(
            shape(&object.shape, &frame, SceneItem::Object(index))?,
            texture(&object.texture, &frame, SceneItem::Object(index))?,
        ))?;
    }
    let (horizon, zenith) = match scene.background {
        Background::Solid(color) => (color, color),
        Background::Gradient { horizon, zenith } => (horizon, zenith),
    };
    let [horizon, zenith] = [horizon, zenith].map(|color| color.map(|c| radiance(c, exposure)));
    Ok(Settings {
        camera,
        authored: scene.camera,
        frame,
        horizon,
        zenith,
        is_gradient: horizon != zenith,
        exposure,
        max_depth: scene.max_depth,
        min_weight: factor(scene.min_weight, 0),
        is_opaque: false,
    })
}

/// Brings another camera to the scale of a prepared scene.
pub(crate) fn moved_camera(
    camera: &scene::Camera,
    frame: &Normalization,
) -> Result<Camera, SceneError> {
    validate::camera(camera)?;
    if !frame.is_near(camera.eye) {
        return Err(SceneError {
            item: SceneItem::Camera,
            field: "eye",
            problem: SceneProblem::OutOfReach,
        });
    }
    self::camera(camera, frame)
}

fn camera(camera: &scene::Camera, frame: &Normalization) -> Result<Camera, SceneError> {
    let error = |field, problem| SceneError {
        item: SceneItem::Camera,
        field,
        problem,
    };
    let view = camera.look_at - camera.eye;
    let forward =
        direction(view.map(Real::to_bits)).ok_or(error("look_at", SceneProblem::NoView))?;
    let up =
        direction(camera.up.map(Real::to_bits)).ok_or(error("up", SceneProblem::NoDirection))?;
    let right = forward.cross(up);
    // The sine between the two, in 2^-60.
    if right.x.abs().max(right.y.abs()).max(right.z.abs()) < 1 << 44 {
        return Err(error("up", SceneProblem::AlongView));
    }
    let right = direction(right).ok_or(error("up", SceneProblem::AlongView))?;
    let up = direction(right.cross(forward)).ok_or(error("up", SceneProblem::AlongView))?;
    Ok(Camera {
        eye: frame.point(camera.eye),
        forward,
        right,
        up,
        tangent: crate::math::tangent_of_half(camera.fovy_deg),
    })
}

fn texture(
    texture: &scene::Texture,
    frame: &Normalization,
    item: SceneItem,
) -> Result<Texture, SceneError> {
    match *texture {
        scene::Texture::Uniform(material) => Ok(Texture::Uniform(material.0)),
        scene::Texture::Checker {
            size,
            axes,
            materials,
        } => {
            crate::geometry::limits::least_size(item, "checker.size", size, frame)?;
            let shift = size.to_bits().leading_zeros();
            let inverse = reciprocal((((size.to_bits() as u64) << shift) >> 32) as u32);
            let phase = axes.map(|axis| {
                let center = match axis {
                    Axis::X => frame.center.x,
                    Axis::Y => frame.center.y,
                    Axis::Z => frame.center.z,
                };
                fraction(center, 2 * size.to_bits())
            });
            Ok(Texture::Checker(Checker {
                mantissa: inverse,
                exponent: (shift as i32 - 32 - frame.exponent) as i8,
                phase,
                axes,
                materials: materials.map(|material| material.0),
            }))
        }
    }
}

/// The fraction of `dividend / divisor`, above 0, as `U0F32`, rounded down.
fn fraction(dividend: i64, divisor: i64) -> u32 {
    // A size is never 0, which the compiler cannot know.
    let mut remainder = dividend.checked_rem_euclid(divisor).unwrap_or(0);
    let mut quotient = 0;
    for _ in 0..32 {
        remainder *= 2;
        quotient *= 2;
        if remainder >= divisor {
            remainder -= divisor;
            quotient += 1;
        }
    }
    quotient
}

fn material(material: &scene::Material, scene: &Scene<'_>, exposure: u8) -> Material {
    let coefficient = |color: Color<Real>| color.map(|c| factor(c, 0));
    let glow = material.le.zip(ambient(material, scene), |le, ambient| {
        radiance(le + ambient, exposure)
    });
    let shading = material.shading.unwrap_or(scene.shading);
    // What is not read is not checked either, and may be anything.
    let read = |value, color| match color == Color::gray(Real::ZERO) {
        true => Real::ONE,
        false => value,
    };
    let shininess = read(material.shininess, material.ks);
    let ior = read(material.ior, material.kt);
    let shift = ior.to_bits().leading_zeros();
    let inverse = u64::from(reciprocal((((ior.to_bits() as u64) << shift) >> 32) as u32));
    // U1F31 * 2^(shift - 32) -> Q28
    let inverse = ((inverse << shift) + (1 << 34)) >> 35;
    Material {
        glow,
        kd: coefficient(material.kd),
        ks: coefficient(material.ks),
        kr: material.kr.map(weight),
        kt: material.kt.map(weight),
        shininess: (shininess.to_bits() >> 16) as u32,
        ior: Length::from_bits(((ior.to_bits() + 8) >> 4) as i32),
        inverse_ior: Length::from_bits(inverse as i32),
        blinn: shading == SpecularModel::BlinnPhong,
        ..Material::default()
    }
}

/// `ka * ia`.
fn ambient(material: &scene::Material, scene: &Scene<'_>) -> Color<Real> {
    material
        .ka
        .zip(scene.ambient, |ka, ia| ka.saturating_mul(ia))
}

/// The power of two that the scene's light is divided by, so that lights and
/// background fit 0 to 1, and what one hit can send back stays below 4.
fn exposure(scene: &Scene<'_>) -> u8 {
    /// Not quite 4, to have room for roundings.
    const MOST: Real = Real::lit("3.99");
    let mut exponent = 0;
    let mut fit = |color: Color<Real>, white: Real| {
        while !color.all(|c| c.to_bits() >> exponent <= white.to_bits()) {
            exponent += 1;
        }
    };
    for light in scene.lights {
        fit(light.diffuse, Real::ONE);
        fit(light.specular, Real::ONE);
    }
    match scene.background {
        Background::Solid(color) => fit(color, Real::ONE),
        Background::Gradient { horizon, zenith } => {
            fit(horizon, Real::ONE);
            fit(zenith, Real::ONE);
        }
    }
    for material in scene.materials {
        let mut sum = ambient(material, scene).zip(material.le, Real::saturating_add);
        for light in scene.lights {
            let diffuse = material.kd.zip(light.diffuse, |k, i| k * i);
            let specular = material.ks.zip(light.specular, |k, i| k * i);
            sum = sum
                .zip(diffuse, Real::saturating_add)
                .zip(specular, Real::saturating_add);
        }
        fit(sum, MOST);
    }
    exponent
}
