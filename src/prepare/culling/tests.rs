use fastrand::Rng;
use heapless::Vec;

use super::*;
use crate::geometry::{BoundingSphere, Plane, Shape, Sphere, SurfaceFlags, Texture};
use crate::math::{Color, Length, Unit, Vec3, Weight};
use crate::prepare::{Light, Material, Object};

const OPAQUE: u16 = 0;
const GLASS: u16 = 1;

fn sphere(x: f64, material: u16) -> Object {
    let center = Vec3::new(Length::from_num(x), Length::ZERO, Length::ZERO);
    let sphere = Sphere::new(center, Length::lit("0.25"));
    Object::new(Shape::Sphere(sphere), Texture::Uniform(material))
}

fn floor(y: f64) -> Object {
    let up = Vec3::new(Unit::ZERO, Unit::ONE, Unit::ZERO);
    let offset = Length::from_num(y).to_bits().into();
    let plane = Shape::Plane(Plane::new(up, offset, None));
    Object::new(plane, Texture::Uniform(OPAQUE))
}

#[test]
fn neighbors_share_a_group() {
    // The objects form three clusters. The list takes one object from each cluster in turn.
    let mut objects = [(); 3 * GROUP].map(|()| sphere(0.0, OPAQUE));
    for (number, object) in objects.iter_mut().enumerate() {
        let cluster = (number % 3) as f64 - 1.0;
        *object = sphere(0.9 * cluster + 0.01 * (number / 3) as f64, OPAQUE);
    }
    let (mut bounded, mut groups) = (Vec::<_, 32>::new(), Vec::<_, 32>::new());
    list_objects(
        &objects,
        &mut bounded,
        &mut groups,
        &mut Vec::<_, 32>::new(),
    );
    assert_eq!(groups.len(), 3);
    let mut seen = [false; 3 * GROUP];
    for group in bounded.chunks(GROUP) {
        let cluster = group[0].object % 3;
        for around in group {
            assert_eq!(around.object % 3, cluster);
            seen[usize::from(around.object)] = true;
        }
    }
    assert!(seen.into_iter().all(|seen| seen));
}

/// Marks isolated objects and returns which objects are marked.
fn isolated<const N: usize>(mut objects: [Object; N]) -> [bool; N] {
    let glass = Material {
        kt: Color::new(Weight::ZERO, Weight::ZERO, Weight::DELTA),
        ..Material::default()
    };
    mark_isolated(&mut objects, &[Material::default(), glass]);
    objects.map(|object| object.flags.intersects(SurfaceFlags::ISOLATED))
}

#[test]
fn glass_is_isolated_if_nothing_reaches_into_it() {
    let (left, right) = (sphere(-0.25, GLASS), sphere(0.251, GLASS));
    assert_eq!(isolated([left, right, floor(0.251)]), [true, true, false]);
    // The left sphere is not isolated if another object touches, encloses or cuts it. An
    // opaque sphere is never isolated.
    assert_eq!(isolated([left, sphere(0.25, GLASS)]), [false, false]);
    assert_eq!(isolated([left, sphere(-0.25, OPAQUE)]), [false, false]);
    assert_eq!(isolated([left, floor(0.25)]), [false, false]);
    assert_eq!(isolated([left, floor(-0.1)]), [false, false]);
    assert_eq!(isolated([sphere(0.0, OPAQUE)]), [false]);
}

/// Places a light at `x` on the x axis and marks the objects that no other object can hide
/// from the light. Returns which objects are marked.
fn unoccluded<const N: usize>(mut objects: [Object; N], x: f64) -> [bool; N] {
    let mut lights = [Light {
        position: Vec3::new(Length::from_num(x), Length::ZERO, Length::ZERO),
        ..Light::default()
    }];
    mark_unoccluded(&mut lights, &mut objects);
    let [light] = lights;
    objects.map(|object| object.flags.intersects(light.unoccluded))
}

#[test]
fn objects_in_front_are_unoccluded() {
    let (left, right) = (sphere(-0.5, OPAQUE), sphere(0.5, OPAQUE));
    assert_eq!(
        unoccluded([left, right, floor(-0.5)], -1.0),
        [true, false, false]
    );
    assert_eq!(unoccluded([left, right], 0.0), [true, true]);
    // A sphere is not marked if the light is inside it or if a plane cuts it. A plane just
    // below the sphere makes no difference.
    assert_eq!(unoccluded([left, right], -0.5), [false, false]);
    assert_eq!(unoccluded([left, floor(0.125)], 1.0), [false, false]);
    assert_eq!(unoccluded([left, floor(-0.26)], 1.0), [true, false]);
    assert!(!SurfaceFlags::unoccluded_from(8).intersects(SurfaceFlags::unoccluded_from(7)));
}

/// Uses shadow rays in double precision to check that no sphere hides a marked sphere from the
/// light.
#[test]
fn unoccluded_spheres_are_lit() {
    let random = &mut Rng::with_seed(1);
    let (mut points, mut hidden) = (0, 0);
    for _ in 0..if cfg!(miri) { 30 } else { 3000 } {
        let mut c = |reach: f64| Length::from_num((2.0 * random.f64() - 1.0) * reach);
        let mut lights = [Light {
            position: Vec3::new(c(1.0), c(1.0), c(1.0)),
            ..Light::default()
        }];
        let mut spheres = [(); 5].map(|()| {
            let center = Vec3::new(c(0.8), c(0.8), c(0.8));
            let sphere = Sphere::new(center, c(0.3).abs() + Length::lit("0.001"));
            Object::new(Shape::Sphere(sphere), Texture::Uniform(OPAQUE))
        });
        mark_unoccluded(&mut lights, &mut spheres);
        let [light] = lights;
        for (number, object) in spheres.iter().enumerate() {
            let Some(bound) = object.shape.bounding_sphere() else {
                continue;
            };
            let [l, b] = [light.position, bound.center].map(exact);
            let radius: f64 = bound.radius.to_num();
            for _ in 0..30 {
                let v = [(); 3].map(|()| random.f64() - 0.5);
                let length = dot(v, v).sqrt();
                let n = v.map(|c| c / length);
                let point = [0, 1, 2].map(|i| b[i] + n[i] * radius);
                let way = [0, 1, 2].map(|i| point[i] - l[i]);
                if dot(way, n) > 0.0 {
                    continue;
                }
                let others = spheres
                    .iter()
                    .enumerate()
                    .filter(|(other, _)| *other != number);
                let is_hidden = others
                    .filter_map(|(_, other)| other.shape.bounding_sphere())
                    .any(|other| is_between(l, way, &other));
                let is_unoccluded = object.flags.intersects(light.unoccluded);
                assert!(!is_unoccluded || !is_hidden, "{light:?} {spheres:?}");
                points += i32::from(is_unoccluded);
                hidden += i32::from(is_hidden);
            }
        }
    }
    assert!(
        points > 100 && hidden > 100,
        "{points} unoccluded, {hidden} occluded"
    );
}

fn exact(v: Vec3<Length>) -> [f64; 3] {
    [v.x, v.y, v.z].map(|c| c.to_num())
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Returns true if a sphere occludes the point at `from + way` from the point `from`.
fn is_between(from: [f64; 3], way: [f64; 3], sphere: &BoundingSphere) -> bool {
    let center = exact(sphere.center);
    let to_center = [0, 1, 2].map(|i| center[i] - from[i]);
    let share = (dot(to_center, way) / dot(way, way)).clamp(0.0, 1.0);
    let off = [0, 1, 2].map(|i| to_center[i] - share * way[i]);
    dot(off, off).sqrt() < sphere.radius.to_num::<f64>()
}
