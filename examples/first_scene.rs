//! Describes a scene in code and draws it on a display. Firmware needs no more than this.
//!
//! `cargo run --example first_scene` writes `first_scene.png`.

pub(crate) mod common;

use std::error::Error;

use common::Display;
use embedded_graphics::prelude::*;
use whitted::scene::{Axis, ClipBox, ior};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Renderer, Scene,
    SceneBuffer, Shape, Texture, color, real, vec3,
};

/// The scene. A `static` scene stays in flash. The compiler evaluates `lit`, which converts
/// decimal numbers to fixed point. A `MaterialId` is an index into `materials`.
pub(crate) static SCENE: Scene = Scene {
    background: Background::Gradient {
        horizon: color!(0.60, 0.76, 0.90),
        zenith: color!(0.03, 0.12, 0.42),
    },
    lights: &[
        Light::point(vec3!(-60, 90, 60), color!(1.2, 1.15, 1.05)),
        Light::point(vec3!(80, 50, 50), color!(0.2, 0.25, 0.35)),
    ],
    materials: &[
        // Red lacquer: it has an ambient, a diffuse and a specular color, and is slightly
        // reflective.
        Material {
            ka: color!(0.08, 0.01, 0.01),
            kd: color!(0.65, 0.05, 0.04),
            ks: Color::gray(real!(0.6)),
            shininess: real!(120),
            kr: Color::gray(real!(0.1)),
            ..Material::BLACK
        },
        // Glass: most light passes through it.
        Material {
            ks: Color::gray(real!(0.7)),
            shininess: real!(300),
            kr: Color::gray(real!(0.08)),
            kt: color!(0.92, 0.95, 0.94),
            ior: ior::GLASS,
            ..Material::BLACK
        },
        // Gold: a mirror that reflects red most and blue least.
        Material {
            kd: color!(0.28, 0.16, 0.03),
            ks: color!(0.7, 0.6, 0.4),
            shininess: real!(150),
            kr: color!(0.8, 0.52, 0.18),
            ..Material::BLACK
        },
        // The materials of the floor's light and dark squares.
        Material {
            ka: Color::gray(real!(0.12)),
            kd: color!(0.7, 0.66, 0.58),
            ..Material::BLACK
        },
        Material {
            ka: color!(0.01, 0.04, 0.05),
            kd: color!(0.05, 0.2, 0.24),
            kr: Color::gray(real!(0.15)),
            ..Material::BLACK
        },
    ],
    objects: &[
        Object {
            shape: Shape::Plane {
                normal: vec3!(0, 1, 0),
                point: vec3!(0, 0, 0),
                bounds: ClipBox {
                    x: Some([real!(-4), real!(4)]),
                    z: Some([real!(-7), real!(5)]),
                    ..ClipBox::NONE
                },
            },
            texture: Texture::Checker {
                size: Real::ONE,
                axes: [Axis::X, Axis::Z],
                materials: [MaterialId(3), MaterialId(4)],
            },
        },
        Object::sphere(vec3!(0.2, 1.2, -1), real!(1.2), MaterialId(2)),
        Object::sphere(vec3!(-1.6, 0.8, 0.9), real!(0.8), MaterialId(1)),
        Object::sphere(vec3!(1.75, 0.7, 0.7), real!(0.7), MaterialId(0)),
        Object::sphere(vec3!(0.2, 0.3, 1.8), real!(0.3), MaterialId(0)),
    ],
    // The arguments are the camera's position, the point that it looks at, and its vertical
    // field of view in degrees.
    ..Scene::new(Camera::new(
        vec3!(0.6, 2.2, 8),
        vec3!(0.1, 0.95, 0),
        real!(30),
    ))
};

/// Draws the scene.
pub(crate) fn picture() -> Result<Display, Box<dyn Error>> {
    let mut display = Display::new(Size::new(320, 240));
    // The buffer has room for 5 objects, 2 lights and 5 materials.
    let mut buffer = SceneBuffer::<5, 2, 5>::new();
    let scene = buffer.prepare(&SCENE)?;
    Renderer::new(&scene, display.size()).draw(&mut display)?;
    Ok(display)
}

fn main() -> Result<(), Box<dyn Error>> {
    common::save("first_scene.png", 1, &[picture()?])
}
