//! Scenes that need a Cargo feature of the library, and one that needs none.

use embedded_graphics_core::geometry::{Point, Size};
use whitted::codec::Crc32;
use whitted::render::{DisplayColor, Output};
use whitted::scene::ClipBox;
use whitted::{
    Camera, Color, Light, Material, MaterialId, Object, PreparedScene, Real, Renderer, Scene,
    Shape, Texture, Vec3, color, real, vec3,
};

const RED: Material = Material {
    kd: color!(0.6, 0.1, 0.05),
    ks: color!(0.4, 0.4, 0.4),
    shininess: real!(30),
    ..Material::BLACK
};
const MIRROR: Material = Material {
    kr: color!(0.8, 0.8, 0.8),
    ..Material::BLACK
};
const GLASS: Material = Material {
    kt: color!(0.9, 0.9, 0.9),
    ior: real!(1.5),
    ..Material::BLACK
};

const CAMERA: Camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33));
const LIGHTS: &[Light] = &[Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE))];
const CENTER: Vec3<Real> = vec3!(0, 1, 0);

const fn scene(objects: &'static [Object], materials: &'static [Material]) -> Scene<'static> {
    Scene {
        lights: LIGHTS,
        materials,
        objects,
        ..Scene::new(CAMERA)
    }
}

const fn object(shape: Shape) -> Object {
    Object {
        shape,
        texture: Texture::Uniform(MaterialId(0)),
    }
}

/// Spheres and planes: needs no feature.
pub static SPHERES_AND_PLANES: Scene = scene(
    &[
        Object::sphere(CENTER, Real::ONE, MaterialId(0)),
        Object::sphere(vec3!(2, 1, -1), Real::ONE, MaterialId(1)),
        Object::floor(Real::ZERO, Texture::Uniform(MaterialId(0))),
        object(Shape::Plane {
            normal: vec3!(0, 0, 1),
            point: vec3!(0, 0, -3),
            bounds: ClipBox {
                x: Some([real!(-2), real!(3)]),
                ..ClipBox::NONE
            },
        }),
    ],
    &[RED, MIRROR],
);

/// A glass sphere: needs `glass`.
pub static GLASS_SPHERE: Scene = scene(
    &[Object::sphere(CENTER, Real::ONE, MaterialId(0))],
    &[GLASS],
);

/// An ellipsoid: needs `quadrics`.
pub static ELLIPSOID: Scene = scene(
    &[object(Shape::Ellipsoid {
        center: CENTER,
        radii: vec3!(1, 0.5, 1),
    })],
    &[RED],
);

/// A sphereflake: needs `sphereflake`.
pub static SPHEREFLAKE: Scene = scene(
    &[Object::sphereflake(CENTER, Real::ONE, 2, MaterialId(0))],
    &[RED],
);

/// CRC-32 of a scene's picture of 64 by 48 pixels, 16 bits per channel.
pub fn checksum(scene: &PreparedScene<'_>) -> u32 {
    let size = Size::new(64, 48);
    let mut renderer = Renderer::new(scene, size);
    let mut crc = Crc32::new();
    for y in 0..size.height {
        for color in renderer.line(y) {
            crc.update_pixel(Color::<u16>::from_radiance(
                color,
                Point::zero(),
                Output::default(),
            ));
        }
    }
    crc.finish()
}
