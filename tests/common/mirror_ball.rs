//! Small scene with a reflective sphere, a floor, a shadow and two bounces.

use whitted::{Camera, Color, Light, Material, MaterialId, Object, Real, Scene, Texture, Vec3};

const RED: Material = Material {
    kd: Color::lit("0.8", "0.1", "0.1"),
    ..Material::BLACK
};

pub(crate) static SCENE: Scene = Scene {
    lights: &[Light::point(
        Vec3::lit("-6", "11", "7"),
        Color::gray(Real::ONE),
    )],
    materials: &[
        RED,
        Material {
            kr: Color::lit("0.5", "0.5", "0.5"),
            ..RED
        },
    ],
    objects: &[
        Object::sphere(Vec3::lit("0", "1", "0"), Real::ONE, MaterialId(1)),
        Object::floor(Real::ZERO, Texture::Uniform(MaterialId(0))),
    ],
    max_depth: 2,
    ..Scene::new(Camera::new(
        Vec3::lit("0", "2", "8"),
        Vec3::lit("0", "1", "0"),
        Real::lit("33"),
    ))
};
