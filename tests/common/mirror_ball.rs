//! Small scene with a reflective sphere, a floor, a shadow and two bounces.

use whitted::{
    Camera, Color, Light, Material, MaterialId, Object, Real, Scene, Texture, color, real, vec3,
};

const RED: Material = Material {
    kd: color!(0.8, 0.1, 0.1),
    ..Material::BLACK
};

pub(crate) static SCENE: Scene = Scene {
    lights: &[Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE))],
    materials: &[
        RED,
        Material {
            kr: color!(0.5, 0.5, 0.5),
            ..RED
        },
    ],
    objects: &[
        Object::sphere(vec3!(0, 1, 0), Real::ONE, MaterialId(1)),
        Object::floor(Real::ZERO, Texture::Uniform(MaterialId(0))),
    ],
    max_depth: 2,
    ..Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)))
};
