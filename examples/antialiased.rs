//! Draws a picture twice: without and with smooth edges.
//!
//! `cargo run --example antialiased` writes `antialiased.png`, which shows both pictures side
//! by side, enlarged 4 times.

pub(crate) mod common;

use std::error::Error;

use common::Display;
use embedded_graphics::prelude::*;
use whitted::render::{AaSample, AntialiasedRenderer, SampleCount};
use whitted::scene::Axis;
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Renderer, Scene,
    SceneBuffer, Texture, color, real, vec3,
};

pub(crate) const SIZE: Size = Size::new(96, 80);

/// A scene with a mirror ball on a checkerboard. It has edges, reflected edges and highlights.
pub(crate) static SCENE: Scene = Scene {
    background: Background::Gradient {
        horizon: color!(0.85, 0.70, 0.52),
        zenith: color!(0.14, 0.22, 0.5),
    },
    lights: &[Light::point(vec3!(-50, 80, 60), color!(1.2, 1.12, 1.05))],
    materials: &[
        // Material 0: the mirror ball.
        Material {
            ks: Color::gray(real!(0.6)),
            shininess: real!(150),
            kr: color!(0.82, 0.84, 0.88),
            ..Material::BLACK
        },
        // Material 1: the white squares of the floor.
        Material {
            ka: Color::gray(real!(0.12)),
            kd: color!(0.75, 0.72, 0.66),
            ..Material::BLACK
        },
        // Material 2: the crimson squares of the floor, and the small crimson ball.
        Material {
            ka: color!(0.06, 0.01, 0.03),
            kd: color!(0.4, 0.05, 0.14),
            ..Material::BLACK
        },
    ],
    objects: &[
        Object::floor(
            Real::ZERO,
            Texture::Checker {
                size: real!(0.8),
                axes: [Axis::X, Axis::Z],
                materials: [MaterialId(1), MaterialId(2)],
            },
        ),
        Object::sphere(vec3!(0, 1.15, 0), real!(1.15), MaterialId(0)),
        Object::sphere(vec3!(1.5, 0.35, 1.3), real!(0.35), MaterialId(2)),
    ],
    ..Scene::new(Camera::new(
        vec3!(1.6, 2.1, 7),
        vec3!(0.2, 0.95, 0),
        real!(27),
    ))
};

/// Returns two pictures of the scene: the first without antialiasing, the second with it.
pub(crate) fn pictures() -> Result<[Display; 2], Box<dyn Error>> {
    let mut buffer = SceneBuffer::<3, 1, 3>::new();
    let scene = buffer.prepare(&SCENE)?;

    let mut plain = Display::new(SIZE);
    Renderer::new(&scene, SIZE).draw(&mut plain)?;

    // The antialiasing renderer stores two lines of samples. A sample takes 16 bytes, so two
    // lines of 96 pixels take 3 KB. With `SampleCount::Four`, a pixel that differs from a
    // neighbor gets 4 more rays. All other pixels get only 1 ray.
    let mut smooth = Display::new(SIZE);
    let mut memory = [AaSample::BLACK; 2 * SIZE.width as usize];
    AntialiasedRenderer::new(&scene, SIZE, SampleCount::Four, &mut memory)?.draw(&mut smooth)?;
    Ok([plain, smooth])
}

fn main() -> Result<(), Box<dyn Error>> {
    common::save("antialiased.png", 4, &pictures()?)
}
