//! Error bounds of the stages of tracing, against double precision on random input.
//!
//! `cargo test --lib error_bounds -- --nocapture` prints the largest error of each stage, which
//! docs/fixed-point.md lists beside the bound.

use fastrand::Rng;

use crate::geometry::{Plane, PrimitivePart, Ray, Shape, Sphere};
use crate::math::{Color, Factor, Length, Unit, Vec3};
use crate::prepare::Camera;
use crate::render::camera_rays::CameraRays;
use crate::tests::largest_error::{LargestError, dot, length, lengths, times, unit, units};
use crate::tests::random;
use crate::tests::random::{between, random_length, unit_vector};
use crate::trace::optics;

const CASES: usize = 200_000;

#[test]
fn camera_rays() {
    let camera = Camera {
        forward: Vec3::new(Unit::ZERO, Unit::ZERO, -Unit::ONE),
        right: Vec3::new(Unit::ONE, Unit::ZERO, Unit::ZERO),
        up: Vec3::new(Unit::ZERO, Unit::ONE, Unit::ZERO),
        tangent: 1 << 27,
        ..Camera::default()
    };
    let (width, height) = (320, 240);
    let view = CameraRays::new(&camera, width, height);
    let mut seen = LargestError::new("direction of a camera ray", -30, 2.5);
    for y in 0..height {
        for (x, direction) in (0..).zip(view.line(y)) {
            let g = 0.5 / f64::from(height);
            let [x, y] = [
                2 * x + 1 - i64::from(width),
                i64::from(height) - 2 * i64::from(y) - 1,
            ]
            .map(|c| c as f64 * g);
            let direction = units(direction.unit());
            seen.add(length(direction - unit(Vec3::new(x, y, -1.0))));
        }
    }
    seen.check();
}

#[test]
fn spheres() {
    let part = &mut PrimitivePart::default();
    let mut random = Rng::with_seed(2);
    let mut off = LargestError::new("sphere: hit off the surface", -28, 3.0);
    let mut across = LargestError::new("sphere: far end of a chord", -28, 4.0);
    let mut turned = LargestError::new("sphere: normal", -28, 0.5);
    for _ in 0..CASES {
        let (radius, size) = random_length(&mut random, 0.02, 0.5);
        let center = random::point(&mut random, 0.5);
        let sphere = Shape::from(Sphere::new(center, radius));
        let ray = random::ray(&mut random);
        let (origin, view) = (ray.origin.coordinates, ray.direction);
        let mut intersect =
            |ray: &Ray, is_origin| sphere.intersect(ray, is_origin, Length::MAX, part, &mut ());
        let Some(distance) = intersect(&ray, false) else {
            continue;
        };
        let from_center = |from: Vec3<Length>, view, distance: Length| {
            let way = times(units(view), distance.to_num());
            lengths(from) + way - lengths(center)
        };
        let out = from_center(origin, view, distance);
        off.add(length(out) - size);

        let at = ray.at(distance);
        let point = at.coordinates;
        let exact = unit(lengths(point) - lengths(center));
        let normal = sphere.surface_at(&at, &PrimitivePart::default()).normal;
        turned.add(length(units(normal) - exact));

        let inward = unit_vector(&mut random);
        if inward.cosine(normal) < 0 {
            let chord = Ray {
                origin: at,
                direction: inward,
                ..ray
            };
            let exit = intersect(&chord, true).unwrap_or_default();
            let out = from_center(point, inward, exit);
            across.add(length(out) - size);
        }
    }
    off.check();
    across.check();
    turned.check();
}

#[test]
fn planes() {
    let mut random = Rng::with_seed(3);
    let mut off = LargestError::new("plane: hit off the surface", -28, 2.5);
    for _ in 0..CASES {
        let offset: i64 = Length::from_num(between(&mut random, -0.7, 0.7))
            .to_bits()
            .into();
        let normal = unit_vector(&mut random);
        let plane = Shape::from(Plane::new(normal, offset, None));
        let ray = random::ray(&mut random);
        let part = &mut PrimitivePart::default();
        let near = plane.intersect(&ray, false, Length::MAX, part, &mut ());
        let Some(distance) = near.filter(|distance| *distance < Length::MAX) else {
            continue;
        };
        let way = times(units(ray.direction), distance.to_num());
        let height = dot(lengths(ray.origin.coordinates) + way, units(normal));
        off.add(height - offset as f64 * 2_f64.powi(-28));
    }
    off.check();
}

#[test]
fn reflected_and_refracted_directions() {
    let mut random = Rng::with_seed(5);
    let mut reflected = LargestError::new("reflected direction", -30, 3.0);
    let mut bent = LargestError::new("refracted direction, sqrt(k) above 2^-10", -28, 256.0);
    for _ in 0..CASES {
        let (view, mut normal) = (unit_vector(&mut random), unit_vector(&mut random));
        if view.cosine(normal) > 0 {
            normal = -normal;
        }
        let cosine = -view.cosine(normal);
        let (v, n) = (units(view), units(normal));
        let c = -dot(v, n);
        let exact = unit(v + times(n, 2.0 * c));
        reflected.add(length(
            units(optics::mirrored(view, normal, cosine)) - exact,
        ));

        let (eta, exact_eta) = random_length(&mut random, 0.25, 4.0);
        let k = 1.0 - exact_eta * exact_eta * (1.0 - c * c);
        let Some(direction) = optics::refracted(view, normal, cosine, eta) else {
            assert!(k < 2_f64.powi(-26), "{k}");
            continue;
        };
        if k > 2_f64.powi(-20) {
            let exact = times(v, exact_eta) + times(n, exact_eta * c - k.sqrt());
            bent.add(length(units(direction) - unit(exact)));
        }
    }
    reflected.check();
    bent.check();
}

#[test]
fn products_of_factors() {
    let mut random = Rng::with_seed(6);
    let mut product = LargestError::new("product of two factors", -15, 0.5);
    for _ in 0..CASES {
        let mut factor = || Factor::from_num(between(&mut random, 0.0, 1.0));
        let (a, b) = (factor(), factor());
        let filtered = Color::new(a, a, a).filtered(Color::new(b, b, b)).r;
        product.add(filtered.to_num::<f64>() - a.to_num::<f64>() * b.to_num::<f64>());
    }
    product.check();
}
