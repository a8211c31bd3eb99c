//! A scene for the examples that show ways of drawing.

use embedded_graphics::prelude::Size;
use whitted::scene::{Axis, ClipBox, ior};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Scene, SceneBuffer,
    Shape, Texture, Vec3,
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
        horizon: Color::lit("0.34", "0.46", "0.68"),
        zenith: Color::lit("0.02", "0.05", "0.26"),
    },
    lights: &[
        Light::point(
            Vec3::lit("-60", "80", "70"),
            Color::lit("1.25", "1.12", "0.92"),
        ),
        Light::point(
            Vec3::lit("90", "50", "30"),
            Color::lit("0.2", "0.22", "0.4"),
        ),
    ],
    materials: &[
        // Gold.
        Material {
            ka: Color::lit("0.10", "0.065", "0.02"),
            kd: Color::lit("0.58", "0.38", "0.12"),
            ks: Color::lit("0.5", "0.42", "0.25"),
            shininess: Real::lit("60"),
            kr: Color::lit("0.34", "0.25", "0.12"),
            ..Material::BLACK
        },
        // Glass.
        Material {
            ks: Color::gray(Real::lit("0.6")),
            shininess: Real::lit("300"),
            kr: Color::gray(Real::lit("0.08")),
            kt: Color::lit("0.90", "0.94", "0.95"),
            ior: ior::GLASS,
            ..Material::BLACK
        },
        // Chrome.
        Material {
            ks: Color::gray(Real::lit("0.6")),
            shininess: Real::lit("200"),
            kr: Color::lit("0.80", "0.82", "0.85"),
            ..Material::BLACK
        },
        // Coral.
        Material {
            ka: Color::lit("0.10", "0.025", "0.02"),
            kd: Color::lit("0.75", "0.16", "0.11"),
            ks: Color::gray(Real::lit("0.4")),
            shininess: Real::lit("40"),
            kr: Color::gray(Real::lit("0.06")),
            ..Material::BLACK
        },
        // The dark squares of the floor.
        Material {
            ka: Color::lit("0.01", "0.02", "0.05"),
            kd: Color::lit("0.04", "0.09", "0.18"),
            kr: Color::gray(Real::lit("0.3")),
            ..Material::BLACK
        },
        // The light squares of the floor.
        Material {
            ka: Color::lit("0.11", "0.10", "0.10"),
            kd: Color::lit("0.62", "0.56", "0.50"),
            kr: Color::gray(Real::lit("0.12")),
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
                    z: Some([Real::lit("-7"), Real::lit("4")]),
                    ..ClipBox::NONE
                },
            },
            texture: Texture::Checker {
                size: Real::ONE,
                axes: [Axis::X, Axis::Z],
                materials: [DARK, LIGHT],
            },
        },
        Object::sphereflake(Vec3::lit("0.1", "1.42", "-0.6"), Real::lit("0.8"), 3, GOLD),
        Object::sphere(Vec3::lit("-1.55", "0.62", "1.3"), Real::lit("0.62"), GLASS),
        Object::sphere(Vec3::lit("1.7", "0.5", "0.9"), Real::lit("0.5"), CHROME),
        Object::sphere(Vec3::lit("0.3", "0.24", "2.1"), Real::lit("0.24"), CORAL),
    ],
    ..Scene::new(Camera::new(
        Vec3::lit("0.5", "2.1", "7.6"),
        Vec3::lit("0.05", "1.2", "0"),
        Real::lit("32"),
    ))
};
