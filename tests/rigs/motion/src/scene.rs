//! Animated scene of the `motion` and `soak` rigs: four spheres over an unbounded floor, as
//! in tests/scenes/four_spheres.toml.

use whitted::animation::{Animation, Interpolation, Keyframe, Target, Track};
use whitted::scene::Axis;
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Scene, Texture, color,
    real, vec3,
};

/// Times of the drawn frames, in seconds.
pub(crate) const TIMES: [Real; 3] = [real!(0), real!(0.7), real!(1.9)];

/// Size of the drawn frames, in pixels.
pub(crate) const SIZE: [u32; 2] = [64, 48];

pub(crate) static SCENE: Scene = Scene {
    lights: &[Light::point(vec3!(9, 16, -6), Color::gray(Real::ONE))],
    materials: &[
        mirror(color!(0.8, 0.8, 0.8), real!(0.5)),
        mirror(color!(0, 1, 0), real!(0.2)),
        mirror(color!(0, 0.8, 0.8), real!(0.3)),
        matt(color!(0.6, 0.6, 0.6)),
        matt(color!(0.6, 0.2, 0.2)),
    ],
    objects: &[
        Object::floor(
            Real::ZERO,
            Texture::Checker {
                size: real!(5),
                axes: [Axis::X, Axis::Z],
                materials: [MaterialId(3), MaterialId(4)],
            },
        ),
        Object::sphere(vec3!(5, 8, -15), real!(5), MaterialId(0)),
        Object::sphere(vec3!(-6, 4, -12), real!(3), MaterialId(0)),
        Object::sphere(vec3!(1, 2, -10), real!(2), MaterialId(1)),
        Object::sphere(vec3!(0, 5, -9), Real::ONE, MaterialId(2)),
    ],
    background: Background::Solid(color!(0.45, 0.25, 0.55)),
    max_depth: 2,
    ..Scene::new(Camera::new(
        vec3!(0, 3, 0),
        vec3!(1, 4, -8),
        real!(48.455491),
    ))
};

const fn mirror(color: Color<Real>, kr: Real) -> Material {
    Material {
        kd: color,
        ks: Color::gray(Real::ONE),
        shininess: real!(32),
        kr: Color::gray(kr),
        ..Material::BLACK
    }
}

const fn matt(color: Color<Real>) -> Material {
    Material {
        kd: color,
        ..Material::BLACK
    }
}

pub(crate) static ANIMATION: Animation = Animation {
    duration: real!(2),
    looping: true,
    tracks: &[
        Track {
            target: Target::CameraOrbit,
            interpolation: Interpolation::Linear,
            keys: &[
                Keyframe::angles(real!(0), real!(-30), real!(0)),
                Keyframe::angles(real!(1), real!(35), real!(20)),
                Keyframe::angles(real!(2), real!(-30), real!(0)),
            ],
        },
        Track {
            target: Target::ObjectPosition(4),
            interpolation: Interpolation::Smooth,
            keys: &[
                Keyframe::vector(real!(0), vec3!(0, 1, -7)),
                Keyframe::vector(real!(0.8), vec3!(1, 6, -8)),
                Keyframe::vector(real!(2), vec3!(0, 1, -7)),
            ],
        },
        Track {
            target: Target::LightPosition(0),
            interpolation: Interpolation::Smooth,
            keys: &[
                Keyframe::vector(real!(0), vec3!(9, 16, -6)),
                Keyframe::vector(real!(1.1), vec3!(-9, 16, 2)),
                Keyframe::vector(real!(2), vec3!(9, 16, -6)),
            ],
        },
    ],
};
