//! A ball hops over another ball. Keyframes move it.
//!
//! `cargo run --example animation` writes `animation.png`, which shows five frames side by
//! side.

pub(crate) mod common;

use std::error::Error;

use common::Display;
use embedded_graphics::prelude::*;
use whitted::animation::{AnimatedScene, Animation, Interpolation, Keyframe, Target, Track};
use whitted::scene::{Axis, ClipBox};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Renderer, Scene,
    SceneBuffer, Shape, Texture, Vec3,
};

/// Times of the frames in seconds.
pub(crate) const TIMES: [&str; 5] = ["0", "0.25", "0.5", "0.75", "1"];

/// The scene before the animation moves it. The hopping ball is object 1, and the mirror ball
/// is object 2.
pub(crate) static SCENE: Scene = Scene {
    background: Background::Gradient {
        horizon: Color::lit("0.55", "0.68", "0.8"),
        zenith: Color::lit("0.08", "0.18", "0.5"),
    },
    lights: &[Light::point(
        Vec3::lit("-4", "9", "6"),
        Color::gray(Real::lit("1.25")),
    )],
    materials: &[
        // Material 0: the orange ball.
        Material {
            ka: Color::lit("0.1", "0.04", "0.01"),
            kd: Color::lit("0.85", "0.3", "0.05"),
            ks: Color::gray(Real::lit("0.4")),
            shininess: Real::lit("50"),
            ..Material::BLACK
        },
        // Material 1: the mirror ball.
        Material {
            ks: Color::gray(Real::lit("0.6")),
            shininess: Real::lit("150"),
            kr: Color::gray(Real::lit("0.8")),
            ..Material::BLACK
        },
        // Material 2: the white squares of the floor.
        Material {
            ka: Color::gray(Real::lit("0.1")),
            kd: Color::gray(Real::lit("0.7")),
            ..Material::BLACK
        },
        // Material 3: the green squares of the floor.
        Material {
            ka: Color::lit("0.01", "0.04", "0.03"),
            kd: Color::lit("0.06", "0.28", "0.2"),
            ..Material::BLACK
        },
    ],
    objects: &[
        Object {
            shape: Shape::Plane {
                normal: Vec3::lit("0", "1", "0"),
                point: Vec3::lit("0", "0", "0"),
                bounds: ClipBox {
                    x: Some([Real::lit("-3"), Real::lit("3")]),
                    z: Some([Real::lit("-2"), Real::lit("2")]),
                    ..ClipBox::NONE
                },
            },
            texture: Texture::Checker {
                size: Real::ONE,
                axes: [Axis::X, Axis::Z],
                materials: [MaterialId(2), MaterialId(3)],
            },
        },
        Object::sphere(
            Vec3::lit("-1.4", "0.5", "0.6"),
            Real::lit("0.5"),
            MaterialId(0),
        ),
        Object::sphere(
            Vec3::lit("0", "0.8", "-0.3"),
            Real::lit("0.8"),
            MaterialId(1),
        ),
    ],
    ..Scene::new(Camera::new(
        Vec3::lit("0", "2.4", "8"),
        Vec3::lit("0", "1.1", "0"),
        Real::lit("29"),
    ))
};

/// An animation that repeats every 2 seconds. The ball hops to the right and back, and the
/// light moves in the same direction as the ball.
pub(crate) static HOPS: Animation = Animation {
    duration: Real::lit("2"),
    looping: true,
    tracks: &[
        Track {
            target: Target::ObjectPosition(1),
            interpolation: Interpolation::Smooth,
            // Smooth interpolation through three keyframes moves the ball on a parabola. Where
            // the ball bounces, two keyframes have the same time, so the path has a corner.
            keys: &[
                Keyframe::vector("0", "-1.4", "0.5", "0.6"),
                Keyframe::vector("0", "-1.4", "0.5", "0.6"),
                Keyframe::vector("0.5", "0", "2.3", "0.6"),
                Keyframe::vector("1", "1.4", "0.5", "0.6"),
                Keyframe::vector("1", "1.4", "0.5", "0.6"),
                Keyframe::vector("1.5", "0", "2.3", "0.6"),
                Keyframe::vector("2", "-1.4", "0.5", "0.6"),
            ],
        },
        Track {
            target: Target::LightPosition(0),
            interpolation: Interpolation::Smooth,
            keys: &[
                Keyframe::vector("0", "-4", "9", "6"),
                Keyframe::vector("1", "4", "9", "6"),
                Keyframe::vector("2", "-4", "9", "6"),
            ],
        },
    ],
};

/// Draws the frame at `time` in seconds.
pub(crate) fn frame(time: Real) -> Result<Display, Box<dyn Error>> {
    // `animated` stores the moved copies of 3 objects and 1 light. Firmware would create
    // `animated` and `buffer` once and use them for all frames.
    let mut animated = AnimatedScene::<3, 1>::new();
    let mut buffer = SceneBuffer::<3, 1, 4>::new();
    let moved = animated.frame(&SCENE, &HOPS, time)?;
    let scene = buffer.prepare(&moved)?;
    let mut display = Display::new(Size::new(120, 120));
    Renderer::new(&scene, display.size()).draw(&mut display)?;
    Ok(display)
}

fn main() -> Result<(), Box<dyn Error>> {
    let frames: Result<Vec<_>, _> = TIMES.iter().map(|time| frame(Real::lit(time))).collect();
    common::save("animation.png", 1, &frames?)
}
