//! A ball hops over another ball. Keyframes move it.
//!
//! `cargo run --example animation` writes `animation.png`, which shows five frames side by
//! side.

pub(crate) mod common;

use std::error::Error;

use common::Display;
use embedded_graphics::prelude::*;
use whitted::animation::{Animation, Interpolation, Keyframe, Target, Track};
use whitted::scene::{Axis, ClipBox};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Renderer, Scene,
    SceneBuffer, Shape, Texture, color, real, vec3,
};

/// Times of the frames in seconds.
pub(crate) const TIMES: [Real; 5] = [real!(0), real!(0.25), real!(0.5), real!(0.75), real!(1)];

/// The scene before the animation moves it. The hopping ball is object 1, and the mirror ball
/// is object 2.
pub(crate) static SCENE: Scene = Scene {
    background: Background::Gradient {
        horizon: color!(0.55, 0.68, 0.8),
        zenith: color!(0.08, 0.18, 0.5),
    },
    lights: &[Light::point(vec3!(-4, 9, 6), Color::gray(real!(1.25)))],
    materials: &[
        // Material 0: the orange ball.
        Material {
            ka: color!(0.1, 0.04, 0.01),
            kd: color!(0.85, 0.3, 0.05),
            ks: Color::gray(real!(0.4)),
            shininess: real!(50),
            ..Material::BLACK
        },
        // Material 1: the mirror ball.
        Material {
            ks: Color::gray(real!(0.6)),
            shininess: real!(150),
            kr: Color::gray(real!(0.8)),
            ..Material::BLACK
        },
        // Material 2: the white squares of the floor.
        Material {
            ka: Color::gray(real!(0.1)),
            kd: Color::gray(real!(0.7)),
            ..Material::BLACK
        },
        // Material 3: the green squares of the floor.
        Material {
            ka: color!(0.01, 0.04, 0.03),
            kd: color!(0.06, 0.28, 0.2),
            ..Material::BLACK
        },
    ],
    objects: &[
        Object {
            shape: Shape::Plane {
                normal: vec3!(0, 1, 0),
                point: vec3!(0, 0, 0),
                bounds: ClipBox {
                    x: Some([real!(-3), real!(3)]),
                    z: Some([real!(-2), real!(2)]),
                    ..ClipBox::NONE
                },
            },
            texture: Texture::Checker {
                size: Real::ONE,
                axes: [Axis::X, Axis::Z],
                materials: [MaterialId(2), MaterialId(3)],
            },
        },
        Object::sphere(vec3!(-1.4, 0.5, 0.6), real!(0.5), MaterialId(0)),
        Object::sphere(vec3!(0, 0.8, -0.3), real!(0.8), MaterialId(1)),
    ],
    ..Scene::new(Camera::new(vec3!(0, 2.4, 8), vec3!(0, 1.1, 0), real!(29)))
};

/// An animation that repeats every 2 seconds. The ball hops to the right and back, and the
/// light moves in the same direction as the ball.
pub(crate) static HOPS: Animation = Animation {
    duration: real!(2),
    looping: true,
    tracks: &[
        Track {
            target: Target::ObjectPosition(1),
            interpolation: Interpolation::Smooth,
            // Smooth interpolation through three keyframes moves the ball on a parabola. Where
            // the ball bounces, two keyframes have the same time, so the path has a corner.
            keys: &[
                Keyframe::vector(real!(0), vec3!(-1.4, 0.5, 0.6)),
                Keyframe::vector(real!(0), vec3!(-1.4, 0.5, 0.6)),
                Keyframe::vector(real!(0.5), vec3!(0, 2.3, 0.6)),
                Keyframe::vector(real!(1), vec3!(1.4, 0.5, 0.6)),
                Keyframe::vector(real!(1), vec3!(1.4, 0.5, 0.6)),
                Keyframe::vector(real!(1.5), vec3!(0, 2.3, 0.6)),
                Keyframe::vector(real!(2), vec3!(-1.4, 0.5, 0.6)),
            ],
        },
        Track {
            target: Target::LightPosition(0),
            interpolation: Interpolation::Smooth,
            keys: &[
                Keyframe::vector(real!(0), vec3!(-4, 9, 6)),
                Keyframe::vector(real!(1), vec3!(4, 9, 6)),
                Keyframe::vector(real!(2), vec3!(-4, 9, 6)),
            ],
        },
    ],
};

/// Draws the frame at `time` in seconds.
pub(crate) fn frame(time: Real) -> Result<Display, Box<dyn Error>> {
    // Firmware would prepare the animation once and use it for all frames.
    let mut buffer = SceneBuffer::<3, 1, 4>::new();
    let mut animation = buffer.prepare_animation(&SCENE, &HOPS)?;
    let scene = animation.frame(time)?;
    let mut display = Display::new(Size::new(120, 120));
    Renderer::new(&scene, display.size()).draw(&mut display)?;
    Ok(display)
}

fn main() -> Result<(), Box<dyn Error>> {
    let frames: Result<Vec<_>, _> = TIMES.into_iter().map(frame).collect();
    common::save("animation.png", 1, &frames?)
}
