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
    SceneBuffer, Shape, Texture, Vec3,
};

/// The scene. A `static` scene stays in flash. The compiler evaluates `lit`, which converts
/// decimal numbers to fixed point. A `MaterialId` is an index into `materials`.
pub(crate) static SCENE: Scene = Scene {
    background: Background::Gradient {
        horizon: Color::lit("0.60", "0.76", "0.90"),
        zenith: Color::lit("0.03", "0.12", "0.42"),
    },
    lights: &[
        Light::point(
            Vec3::lit("-60", "90", "60"),
            Color::lit("1.2", "1.15", "1.05"),
        ),
        Light::point(
            Vec3::lit("80", "50", "50"),
            Color::lit("0.2", "0.25", "0.35"),
        ),
    ],
    materials: &[
        // Red lacquer: it has an ambient, a diffuse and a specular color, and is slightly
        // reflective.
        Material {
            ka: Color::lit("0.08", "0.01", "0.01"),
            kd: Color::lit("0.65", "0.05", "0.04"),
            ks: Color::gray(Real::lit("0.6")),
            shininess: Real::lit("120"),
            kr: Color::gray(Real::lit("0.1")),
            ..Material::BLACK
        },
        // Glass: most light passes through it.
        Material {
            ks: Color::gray(Real::lit("0.7")),
            shininess: Real::lit("300"),
            kr: Color::gray(Real::lit("0.08")),
            kt: Color::lit("0.92", "0.95", "0.94"),
            ior: ior::GLASS,
            ..Material::BLACK
        },
        // Gold: a mirror that reflects red most and blue least.
        Material {
            kd: Color::lit("0.28", "0.16", "0.03"),
            ks: Color::lit("0.7", "0.6", "0.4"),
            shininess: Real::lit("150"),
            kr: Color::lit("0.8", "0.52", "0.18"),
            ..Material::BLACK
        },
        // The materials of the floor's light and dark squares.
        Material {
            ka: Color::gray(Real::lit("0.12")),
            kd: Color::lit("0.7", "0.66", "0.58"),
            ..Material::BLACK
        },
        Material {
            ka: Color::lit("0.01", "0.04", "0.05"),
            kd: Color::lit("0.05", "0.2", "0.24"),
            kr: Color::gray(Real::lit("0.15")),
            ..Material::BLACK
        },
    ],
    objects: &[
        Object {
            shape: Shape::Plane {
                normal: Vec3::lit("0", "1", "0"),
                point: Vec3::lit("0", "0", "0"),
                bounds: ClipBox {
                    x: Some([Real::lit("-4"), Real::lit("4")]),
                    z: Some([Real::lit("-7"), Real::lit("5")]),
                    ..ClipBox::NONE
                },
            },
            texture: Texture::Checker {
                size: Real::ONE,
                axes: [Axis::X, Axis::Z],
                materials: [MaterialId(3), MaterialId(4)],
            },
        },
        Object::sphere(
            Vec3::lit("0.2", "1.2", "-1"),
            Real::lit("1.2"),
            MaterialId(2),
        ),
        Object::sphere(
            Vec3::lit("-1.6", "0.8", "0.9"),
            Real::lit("0.8"),
            MaterialId(1),
        ),
        Object::sphere(
            Vec3::lit("1.75", "0.7", "0.7"),
            Real::lit("0.7"),
            MaterialId(0),
        ),
        Object::sphere(
            Vec3::lit("0.2", "0.3", "1.8"),
            Real::lit("0.3"),
            MaterialId(0),
        ),
    ],
    // The arguments are the camera's position, the point that it looks at, and its vertical
    // field of view in degrees.
    ..Scene::new(Camera::new(
        Vec3::lit("0.6", "2.2", "8"),
        Vec3::lit("0.1", "0.95", "0"),
        Real::lit("30"),
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
