//! Tests that culling does not change pictures. The tests compare each pixel of a culled scanline
//! with a ray that is tested against all objects.
#![allow(clippy::unwrap_used)]
extern crate std;

use fastrand::Rng;
use std::boxed::Box;
use std::println;
use std::vec::Vec;

use crate::geometry::PrimitivePart;
use crate::math::{Color, Real, Vec3};
use crate::render::camera_rays::CameraRays;
use crate::render::scanline::ScanlineTracer;
use crate::scene::{
    Background, Camera, ClipBox, Material, MaterialId, Object, Scene, Shape, Texture,
};
use crate::scene_buffer::SceneBuffer;
use crate::trace::{Candidates, MAX_CANDIDATES, Tracer};

const SCENES: u64 = if cfg!(miri) { 1 } else { 150 };

fn real(rng: &mut Rng, low: f64, high: f64) -> Real {
    Real::from_num(low + (high - low) * rng.f64())
}

fn point(rng: &mut Rng, max: f64) -> Vec3<Real> {
    let mut c = || real(rng, -max, max);
    Vec3::new(c(), c(), c())
}

/// Returns a random shape. Most shapes are spheres. The spheres vary widely in size, and some
/// contain the eye.
fn shape(rng: &mut Rng) -> Shape {
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

/// Returns materials that emit different colors. The color of a pixel therefore identifies the
/// material of the object.
fn materials(rng: &mut Rng) -> Vec<Material> {
    let mut glow = || real(rng, 0.1, 1.0);
    (0..8)
        .map(|_| Material {
            le: Color::new(glow(), glow(), glow()),
            ..Material::default()
        })
        .collect()
}

/// Draws a scene with culling. Compares each pixel with a ray that is tested against all objects.
/// Returns the number of pixels that show an object.
fn compare_culled(scene: &Scene<'_>, [width, height]: [u32; 2]) -> usize {
    let mut buffer = Box::new(SceneBuffer::<96, 1, 8>::new());
    let prepared = buffer.prepare(scene).unwrap();
    let rays = CameraRays::new(&prepared.settings.camera, width, height);
    let (mut tracer, mut part) = (ScanlineTracer::new(&prepared), PrimitivePart::default());
    let mut covered = 0;
    for y in 0..height {
        let directions = rays.line(y);
        let observer = &mut ();
        let pixels = tracer.pixels(&rays, y, rays.columns(), observer);
        for ((x, color), direction) in pixels.zip(directions) {
            let all = &mut Candidates::default();
            let mut tracer = Tracer {
                scene: &prepared,
                part: &mut part,
                observer: &mut (),
            };
            let expected = tracer.trace_camera_ray(direction, all);
            assert_eq!(color, expected, "{scene:?}, at ({x}, {y})");
            covered += usize::from(color != Color::default());
        }
    }
    covered
}

fn scene<'s>(camera: Camera, objects: &'s [Object], materials: &'s [Material]) -> Scene<'s> {
    Scene {
        objects,
        materials,
        background: Background::Solid(Color::gray(Real::ZERO)),
        ..Scene::new(camera)
    }
}

#[test]
fn culling_does_not_change_pixels_of_random_scenes() {
    let mut rng = Rng::with_seed(7);
    let (mut seen, mut pixels) = (0, 0);
    for number in 0..SCENES {
        let materials = materials(&mut rng);
        let objects: Vec<_> = (0..rng.u16(1..90))
            .map(|n| Object {
                shape: shape(&mut rng),
                texture: Texture::Uniform(MaterialId(n % 8)),
            })
            .collect();
        let fovy = real(&mut rng, 2.0, 169.0);
        let camera = Camera::new(point(&mut rng, 2.5), point(&mut rng, 2.0), fovy);
        let size = [[64, 48], [17, 90], [120, 9]][number as usize % 3];
        seen += compare_culled(&scene(camera, &objects, &materials), size);
        pixels += (size[0] * size[1]) as usize;
    }
    println!("{seen} of {pixels} pixels covered");
    // A single scene may fill the whole picture.
    assert!(seen > pixels / 4 && (SCENES == 1 || seen < pixels * 9 / 10));
}

/// The planes of this test have random clip boxes. Some planes reach beyond the near range
/// (coordinates within ±3.5). Other planes have a visible edge.
#[test]
fn culling_does_not_change_pixels_of_level_planes() {
    let mut rng = Rng::with_seed(9);
    let size = if cfg!(miri) { [12, 16] } else { [48, 64] };
    let (mut seen, mut pixels) = (0, 0);
    for _ in 0..SCENES {
        let materials = materials(&mut rng);
        let objects: Vec<_> = (0..rng.u16(1..4))
            .map(|n| {
                let max = 10_f64.powf(3.0 * rng.f64());
                let mut bound = || {
                    let low = real(&mut rng, -max, max);
                    let high = low + real(&mut rng, 0.0, max);
                    rng.bool().then_some([low, high])
                };
                let bounds = ClipBox {
                    x: bound(),
                    y: None,
                    z: bound(),
                };
                let shape = Shape::Plane {
                    normal: Vec3::new(0, 1, 0).map(Real::from_num),
                    point: point(&mut rng, 1.0),
                    bounds,
                };
                let texture = Texture::Uniform(MaterialId(n));
                Object { shape, texture }
            })
            .collect();
        let camera = Camera::new(
            point(&mut rng, 2.0),
            point(&mut rng, 2.0),
            real(&mut rng, 20.0, 120.0),
        );
        seen += compare_culled(&scene(camera, &objects, &materials), size);
        pixels += (size[0] * size[1]) as usize;
    }
    println!("{seen} of {pixels} pixels covered");
    assert!(seen > pixels / 10);
}

/// A scanline has room for the spans of `MAX_CANDIDATES` objects. The test draws rows of
/// `MAX_CANDIDATES - 1`, `MAX_CANDIDATES` and `MAX_CANDIDATES + 1` spheres. It draws each row once
/// with a plane behind the spheres and once without.
#[test]
fn scanline_with_too_many_objects_shows_all_objects() {
    let mut rng = Rng::with_seed(8);
    let materials = materials(&mut rng);
    let at = |x: i32, z: i32| Vec3::new(x, 0, z).map(Real::from_num);
    let middle = MAX_CANDIDATES as i32 / 2;
    let camera = Camera::new(at(middle, 80), at(middle, 0), Real::from_num(2.5));
    for count in MAX_CANDIDATES as u16 - 1..=MAX_CANDIDATES as u16 + 1 {
        let spheres = (0..count).map(|n| Shape::Sphere {
            center: at(n.into(), 0),
            radius: Real::from_num(0.6),
        });
        let wall = Shape::Plane {
            normal: at(0, 1),
            point: at(0, -10),
            bounds: Default::default(),
        };
        let objects: Vec<_> = spheres
            .chain([wall])
            .zip(0..)
            .map(|(shape, n)| Object {
                shape,
                texture: Texture::Uniform(MaterialId(n % 8)),
            })
            .collect();
        for objects in [&objects[..], &objects[..count.into()]] {
            assert!(compare_culled(&scene(camera, objects, &materials), [160, 8]) > 0);
        }
    }
}
