//! Animated scene of the `motion` and `soak` rigs: four spheres over an unbounded floor, as
//! in tests/scenes/four_spheres.toml.

use whitted::animation::{Animation, Interpolation, Keyframe, Target, Track};
use whitted::scene::Axis;
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Scene, Texture, Vec3,
};

/// Times of the drawn frames, in seconds.
pub(crate) const TIMES: [Real; 3] = [Real::lit("0"), Real::lit("0.7"), Real::lit("1.9")];

/// Size of the drawn frames, in pixels.
pub(crate) const SIZE: [u32; 2] = [64, 48];

pub(crate) static SCENE: Scene = Scene {
    lights: &[Light::point(
        Vec3::lit("9", "16", "-6"),
        Color::gray(Real::ONE),
    )],
    materials: &[
        mirror(["0.8", "0.8", "0.8"], "0.5"),
        mirror(["0", "1", "0"], "0.2"),
        mirror(["0", "0.8", "0.8"], "0.3"),
        matt(["0.6", "0.6", "0.6"]),
        matt(["0.6", "0.2", "0.2"]),
    ],
    objects: &[
        Object::floor(
            Real::ZERO,
            Texture::Checker {
                size: Real::lit("5"),
                axes: [Axis::X, Axis::Z],
                materials: [MaterialId(3), MaterialId(4)],
            },
        ),
        Object::sphere(Vec3::lit("5", "8", "-15"), Real::lit("5"), MaterialId(0)),
        Object::sphere(Vec3::lit("-6", "4", "-12"), Real::lit("3"), MaterialId(0)),
        Object::sphere(Vec3::lit("1", "2", "-10"), Real::lit("2"), MaterialId(1)),
        Object::sphere(Vec3::lit("0", "5", "-9"), Real::ONE, MaterialId(2)),
    ],
    background: Background::Solid(Color::lit("0.45", "0.25", "0.55")),
    max_depth: 2,
    ..Scene::new(Camera::new(
        Vec3::lit("0", "3", "0"),
        Vec3::lit("1", "4", "-8"),
        Real::lit("48.455491"),
    ))
};

const fn mirror(color: [&str; 3], kr: &str) -> Material {
    let [r, g, b] = color;
    Material {
        kd: Color::lit(r, g, b),
        ks: Color::gray(Real::ONE),
        shininess: Real::lit("32"),
        kr: Color::gray(Real::lit(kr)),
        ..Material::BLACK
    }
}

const fn matt(color: [&str; 3]) -> Material {
    let [r, g, b] = color;
    Material {
        kd: Color::lit(r, g, b),
        ..Material::BLACK
    }
}

pub(crate) static ANIMATION: Animation = Animation {
    duration: Real::lit("2"),
    looping: true,
    tracks: &[
        Track {
            target: Target::CameraOrbit,
            interpolation: Interpolation::Linear,
            keys: &[
                Keyframe::angles("0", "-30", "0"),
                Keyframe::angles("1", "35", "20"),
                Keyframe::angles("2", "-30", "0"),
            ],
        },
        Track {
            target: Target::ObjectPosition(4),
            interpolation: Interpolation::Smooth,
            keys: &[
                Keyframe::vector("0", "0", "1", "-7"),
                Keyframe::vector("0.8", "1", "6", "-8"),
                Keyframe::vector("2", "0", "1", "-7"),
            ],
        },
        Track {
            target: Target::LightPosition(0),
            interpolation: Interpolation::Smooth,
            keys: &[
                Keyframe::vector("0", "9", "16", "-6"),
                Keyframe::vector("1.1", "-9", "16", "2"),
                Keyframe::vector("2", "9", "16", "-6"),
            ],
        },
    ],
};
