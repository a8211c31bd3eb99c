//! A line of a picture has the colors of its pixels, one by one: what a line
//! passes over as out of view is met by no ray.

#![allow(clippy::unwrap_used)]

use embedded_graphics::geometry::Size;
use fastrand::Rng;
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Renderer, Scene,
    SceneBuffer, Shape, Texture, Vec3,
};

const SCENES: u64 = 150;

fn real(rng: &mut Rng, low: f64, high: f64) -> Real {
    Real::from_num(low + (high - low) * rng.f64())
}

fn point(rng: &mut Rng, reach: f64) -> Vec3<Real> {
    let mut c = || real(rng, -reach, reach);
    Vec3::new(c(), c(), c())
}

/// Spheres of all sizes, some around the eye, a few others, and planes.
fn object(rng: &mut Rng) -> Shape {
    let center = point(rng, 2.0);
    let radius = Real::from_num(10_f64.powf(-2.3 + 2.5 * rng.f64()));
    match rng.u8(0..10) {
        0 => Shape::Ellipsoid {
            center,
            radii: Vec3::new(radius, radius / 2, radius * 2),
        },
        1 => Shape::Cylinder {
            origin: center,
            radius,
            y: Some([-radius, radius * 2]),
        },
        2 => Shape::Cone {
            origin: center,
            radius,
            height: radius * 2,
            y: Some([Real::ZERO, radius]),
        },
        3 => Shape::Paraboloid {
            origin: center,
            y: [radius / 8, radius],
        },
        4 => Shape::Plane {
            normal: point(rng, 1.0),
            point: center,
            bounds: Default::default(),
        },
        _ => Shape::Sphere { center, radius },
    }
}

#[test]
fn a_line_has_the_colors_of_its_pixels() {
    let mut rng = Rng::with_seed(7);
    let (mut covered, mut pixels) = (0, 0);
    for scene in 0..SCENES {
        let materials: Vec<_> = (0..8)
            .map(|_| Material {
                le: Color::new(
                    real(&mut rng, 0.1, 1.0),
                    real(&mut rng, 0.1, 1.0),
                    real(&mut rng, 0.1, 1.0),
                ),
                ..Material::default()
            })
            .collect();
        let objects: Vec<_> = (0..rng.u16(1..90))
            .map(|n| Object {
                shape: object(&mut rng),
                texture: Texture::Uniform(MaterialId(n % 8)),
            })
            .collect();
        let fovy = real(&mut rng, 2.0, 169.0);
        let camera = Camera::new(point(&mut rng, 2.5), point(&mut rng, 2.0), fovy);
        let lights: [Light; 0] = [];
        let scene_of = Scene {
            objects: &objects,
            materials: &materials,
            lights: &lights,
            background: Background::Solid(Color::gray(Real::ZERO)),
            ..Scene::new(camera)
        };
        let mut buffer = Box::new(SceneBuffer::<96, 1, 8>::new());
        let prepared = buffer.prepare(&scene_of).unwrap();
        let size = [(64, 48), (17, 90), (120, 9)][scene as usize % 3];
        let mut lines = Renderer::new(&prepared, Size::new(size.0, size.1));
        let mut single = Renderer::new(&prepared, Size::new(size.0, size.1));
        for y in 0..size.1 {
            for (x, color) in (0..).zip(lines.line(y)) {
                assert_eq!(color, single.pixel(x, y), "scene {scene}, at ({x}, {y})");
                covered += usize::from(color != Color::default());
                pixels += 1;
            }
        }
    }
    println!("{covered} of {pixels} pixels covered");
    assert!(covered > pixels / 4 && covered < pixels * 9 / 10);
}
