//! A scene for the examples that show ways of drawing.

use embedded_graphics::prelude::Size;
use whitted::scene::{Axis, ClipBox, ior};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Scene, SceneBuffer,
    Shape, Texture, color, real, vec3,
};

/// Size of the picture in pixels.
pub(crate) const SIZE: Size = Size::new(160, 120);

/// A buffer for [`SCENE`]. It has room for 5 objects, 2 lights and 6 materials.
pub(crate) type Buffer = SceneBuffer<5, 2, 6>;

const GOLD: MaterialId = MaterialId(0);
const GLASS: MaterialId = MaterialId(1);
const CHROME: MaterialId = MaterialId(2);
const CORAL: MaterialId = MaterialId(3);
const DARK: MaterialId = MaterialId(4);
const LIGHT: MaterialId = MaterialId(5);

/// A scene at dusk: a sphereflake of 1,885 golden spheres lies on a polished floor.
pub(crate) static SCENE: Scene = Scene {
    background: Background::Gradient {
        horizon: color!(0.34, 0.46, 0.68),
        zenith: color!(0.02, 0.05, 0.26),
    },
    lights: &[
        Light::point(vec3!(-60, 80, 70), color!(1.25, 1.12, 0.92)),
        Light::point(vec3!(90, 50, 30), color!(0.2, 0.22, 0.4)),
    ],
    materials: &[
        // Gold.
        Material {
            ka: color!(0.10, 0.065, 0.02),
            kd: color!(0.58, 0.38, 0.12),
            ks: color!(0.5, 0.42, 0.25),
            shininess: real!(60),
            kr: color!(0.34, 0.25, 0.12),
            ..Material::BLACK
        },
        // Glass.
        Material {
            ks: Color::gray(real!(0.6)),
            shininess: real!(300),
            kr: Color::gray(real!(0.08)),
            kt: color!(0.90, 0.94, 0.95),
            ior: ior::GLASS,
            ..Material::BLACK
        },
        // Chrome.
        Material {
            ks: Color::gray(real!(0.6)),
            shininess: real!(200),
            kr: color!(0.80, 0.82, 0.85),
            ..Material::BLACK
        },
        // Coral.
        Material {
            ka: color!(0.10, 0.025, 0.02),
            kd: color!(0.75, 0.16, 0.11),
            ks: Color::gray(real!(0.4)),
            shininess: real!(40),
            kr: Color::gray(real!(0.06)),
            ..Material::BLACK
        },
        // The dark squares of the floor.
        Material {
            ka: color!(0.01, 0.02, 0.05),
            kd: color!(0.04, 0.09, 0.18),
            kr: Color::gray(real!(0.3)),
            ..Material::BLACK
        },
        // The light squares of the floor.
        Material {
            ka: color!(0.11, 0.10, 0.10),
            kd: color!(0.62, 0.56, 0.50),
            kr: Color::gray(real!(0.12)),
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
                    z: Some([real!(-7), real!(4)]),
                    ..ClipBox::NONE
                },
            },
            texture: Texture::Checker {
                size: Real::ONE,
                axes: [Axis::X, Axis::Z],
                materials: [DARK, LIGHT],
            },
        },
        Object::sphereflake(vec3!(0.1, 1.42, -0.6), real!(0.8), 3, GOLD),
        Object::sphere(vec3!(-1.55, 0.62, 1.3), real!(0.62), GLASS),
        Object::sphere(vec3!(1.7, 0.5, 0.9), real!(0.5), CHROME),
        Object::sphere(vec3!(0.3, 0.24, 2.1), real!(0.24), CORAL),
    ],
    ..Scene::new(Camera::new(
        vec3!(0.5, 2.1, 7.6),
        vec3!(0.05, 1.2, 0),
        real!(32),
    ))
};
