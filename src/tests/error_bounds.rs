//! The error of each stage of tracing, measured against double precision on
//! random input.
//!
//! `cargo test --lib budget -- --nocapture` prints the largest seen, which
//! docs/fixed-point.md lists beside the bounds that are asserted here.

#![cfg(test)]

extern crate std;

use std::println;

use fixed::types::{I8F56, U0F32};

use crate::geometry::{
    Cone, Cylinder, Ellipsoid, Form, OriginSurface, Paraboloid, Plane, Point, Quadric, Ray, Sphere,
    Sphereflake, SphereflakeParams,
};
use crate::math::{Color, Factor, Length, Unit, Vec3, direction};
use crate::prepare::Camera;
use crate::render::camera_rays::CameraRays;
use crate::trace::optics;

type Floats = Vec3<f64>;

/// Steele, Lea and Flood 2014: SplitMix64.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        low + (high - low) * ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn point(&mut self, reach: f64) -> Vec3<Length> {
        let mut c = || Length::from_num(self.between(-reach, reach));
        Vec3::new(c(), c(), c())
    }

    fn direction(&mut self) -> Vec3<Unit> {
        direction(self.point(1.0).map(|c| c.to_bits().into())).unwrap_or(Vec3::new(
            Unit::ONE,
            Unit::ZERO,
            Unit::ZERO,
        ))
    }

    /// From somewhere towards somewhere near the middle.
    fn ray(&mut self) -> Ray {
        let (from, to) = (self.point(3.0), self.point(0.7));
        Ray {
            origin: Point::near(from),
            direction: (to - from).normalized().0,
            start: OriginSurface::NOWHERE,
        }
    }
}

fn lengths(v: Vec3<Length>) -> Floats {
    v.map(Length::to_num)
}

fn units(v: Vec3<Unit>) -> Floats {
    v.map(Unit::to_num)
}

fn dot(a: Floats, b: Floats) -> f64 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

fn times(a: Floats, k: f64) -> Floats {
    a.map(|c| c * k)
}

fn unit(a: Floats) -> Floats {
    times(a, 1.0 / dot(a, a).sqrt())
}

fn difference(a: Floats, b: Floats) -> f64 {
    dot(a - b, a - b).sqrt()
}

/// The largest error of a stage, in units of a power of two.
struct Seen {
    stage: &'static str,
    exponent: i32,
    bound: f64,
    largest: f64,
    count: u32,
}

impl Seen {
    fn new(stage: &'static str, exponent: i32, bound: f64) -> Self {
        Self {
            stage,
            exponent,
            bound,
            largest: 0.0,
            count: 0,
        }
    }

    fn add(&mut self, error: f64) {
        self.largest = self.largest.max(error.abs() * 2_f64.powi(-self.exponent));
        self.count += 1;
    }
}

impl Seen {
    fn report(self) {
        let Self {
            stage,
            exponent,
            bound,
            largest,
            count,
        } = self;
        println!("{stage}: {largest:.2} of {bound} * 2^{exponent}, {count} times");
        assert!(count > 10_000, "{stage}: seen {count} times");
        assert!(largest <= bound, "{stage}");
    }
}

const CASES: usize = 200_000;

#[test]
fn eye_rays() {
    let camera = Camera {
        forward: Vec3::new(Unit::ZERO, Unit::ZERO, -Unit::ONE),
        right: Vec3::new(Unit::ONE, Unit::ZERO, Unit::ZERO),
        up: Vec3::new(Unit::ZERO, Unit::ONE, Unit::ZERO),
        tangent: 1 << 27,
        ..Camera::default()
    };
    let (width, height) = (320, 240);
    let view = CameraRays::new(&camera, width, height);
    let mut seen = Seen::new("direction of an eye ray", -30, 2.5);
    for y in 0..height {
        for (x, direction) in (0..).zip(view.line(y)) {
            let g = 0.5 / f64::from(height);
            let [x, y] = [
                2 * x + 1 - i64::from(width),
                i64::from(height) - 2 * i64::from(y) - 1,
            ]
            .map(|c| c as f64 * g);
            let direction = units(direction.unit());
            seen.add(difference(direction, unit(Vec3::new(x, y, -1.0))));
        }
    }
    seen.report();
}

/// How far hits are from their surface, and normals from the gradient there.
///
/// `function` is the implicit function and its gradient.
fn quadric(
    name: [&'static str; 2],
    bounds: [f64; 2],
    mut make: impl FnMut(&mut Random) -> (Quadric, [f64; 3]),
    function: impl Fn(Floats, [f64; 3]) -> (f64, Floats),
) {
    let mut random = Random(1);
    let mut off = Seen::new(name[0], -28, bounds[0]);
    let mut turned = Seen::new(name[1], -28, bounds[1]);
    for _ in 0..CASES {
        let (quadric, size) = make(&mut random);
        let ray = random.ray();
        let Some(distance) = quadric.nearest(&ray, None).and_then(|t| t.near()) else {
            continue;
        };
        let way = times(units(ray.direction), distance.to_num());
        let exact = lengths(ray.origin.coordinates) + way - lengths(quadric.center);
        let (value, gradient) = function(exact, size);
        let steepness = dot(gradient, gradient).sqrt();
        // At a cone's apex there is no normal, and a prepared cone ends in time.
        if steepness < 0.005 || dot(exact, exact) > 3.0 {
            continue;
        }
        off.add(value / steepness);

        let point = ray.at(distance);
        let (_, gradient) = function(lengths(point.coordinates - quadric.center), size);
        turned.add(difference(units(quadric.normal(point)), unit(gradient)));
    }
    off.report();
    turned.report();
}

fn length(random: &mut Random, low: f64, high: f64) -> (Length, f64) {
    let length = Length::from_num(random.between(low, high));
    (length, length.to_num())
}

fn clamp(random: &mut Random, center: Vec3<Length>) -> Option<[Length; 2]> {
    let half = Length::from_num(random.between(0.05, 0.5));
    Some([center.y - half, center.y + half])
}

#[test]
fn ellipsoids() {
    quadric(
        ["ellipsoid: hit off the surface", "ellipsoid: normal"],
        [16.0, 50.0],
        |random| {
            let radii = [0; 3].map(|_| random.between(0.05, 0.5));
            let shortest = radii.iter().copied().fold(1.0, f64::min);
            let [a, b, c] = radii.map(|radius| Unit::from_num(shortest / radius));
            let form = Ellipsoid {
                squeeze: Vec3::new(a, b, c),
                radius: Length::from_num(shortest),
            };
            // As they are after rounding.
            let sizes = [a, b, c].map(|k| form.radius.to_num::<f64>() / k.to_num::<f64>());
            let center = random.point(0.5);
            let form = Form::Ellipsoid(form);
            (
                Quadric {
                    center,
                    clamp: None,
                    form,
                },
                sizes,
            )
        },
        |p, [a, b, c]| {
            let squared = Vec3::new(a * a, b * b, c * c);
            let scaled = p.zip(squared, |p, r| p / r);
            (dot(p, scaled) - 1.0, times(scaled, 2.0))
        },
    );
}

#[test]
fn cylinders() {
    quadric(
        ["cylinder: hit off the surface", "cylinder: normal"],
        [4.0, 0.5],
        |random| {
            let (radius, size) = length(random, 0.02, 0.5);
            let center = random.point(0.5);
            let clamp = clamp(random, center);
            let form = Form::Cylinder(Cylinder { radius });
            (
                Quadric {
                    center,
                    clamp,
                    form,
                },
                [size; 3],
            )
        },
        |p, [r, ..]| {
            let p = Vec3 { y: 0.0, ..p };
            (dot(p, p) - r * r, times(p, 2.0))
        },
    );
}

#[test]
fn cones() {
    quadric(
        ["cone: hit off the surface", "cone: normal"],
        [400.0, 160.0],
        |random| {
            let slope = 10_f64.powf(random.between(-1.0, 1.0));
            let steep = |k: f64| Unit::from_num(k.min(1.0) / 2.0);
            let (radial, axial) = (steep(1.0 / slope), steep(slope));
            let (radius, size) = length(random, -0.2, 0.2);
            let center = random.point(0.5);
            let clamp = clamp(random, center);
            let form = Form::Cone(Cone {
                radial,
                axial,
                radius,
            });
            let sizes = [radial.to_num(), axial.to_num(), size];
            (
                Quadric {
                    center,
                    clamp,
                    form,
                },
                sizes,
            )
        },
        |p, [radial, axial, radius]| {
            let v = radius - axial * p.y;
            let value = radial * radial * (p.x * p.x + p.z * p.z) - v * v;
            let side = 2.0 * radial * radial;
            (value, Vec3::new(side * p.x, 2.0 * v * axial, side * p.z))
        },
    );
}

#[test]
fn paraboloids() {
    quadric(
        ["paraboloid: hit off the surface", "paraboloid: normal"],
        [4.0, 0.5],
        |random| {
            let focus = random.between(0.0, 6.0) as u8;
            let squared = random.between(0.01, 0.2);
            let center = random.point(0.5);
            let clamp = clamp(random, center);
            let form = Form::Paraboloid(Paraboloid {
                radius_squared: I8F56::from_num(squared),
                squeeze: 0,
                focus,
            });
            let sizes = [squared, 2_f64.powi(-i32::from(focus)), 0.0];
            (
                Quadric {
                    center,
                    clamp,
                    form,
                },
                sizes,
            )
        },
        |p, [squared, g, _]| {
            let value = p.x * p.x + p.z * p.z - g * p.y - squared;
            (value, Vec3::new(2.0 * p.x, -g, 2.0 * p.z))
        },
    );
}

#[test]
fn spheres() {
    let mut random = Random(2);
    let mut off = Seen::new("sphere: hit off the surface", -28, 3.0);
    let mut across = Seen::new("sphere: far end of a chord", -28, 4.0);
    let mut turned = Seen::new("sphere: normal", -28, 0.5);
    for _ in 0..CASES {
        let (radius, size) = length(&mut random, 0.02, 0.5);
        let sphere = Sphere::new(random.point(0.5), radius);
        let ray = random.ray();
        let (origin, view) = (ray.origin.coordinates, ray.direction);
        let Some(distance) = sphere.distance(origin, view) else {
            continue;
        };
        let from_center = |from: Vec3<Length>, view, distance: Length| {
            let way = times(units(view), distance.to_num());
            lengths(from) + way - lengths(sphere.center)
        };
        let out = from_center(origin, view, distance);
        off.add(dot(out, out).sqrt() - size);

        let point = ray.at(distance).coordinates;
        let exact = unit(lengths(point) - lengths(sphere.center));
        let normal = sphere.normal(point);
        turned.add(difference(units(normal), exact));

        let inward = random.direction();
        if inward.cosine(normal) < 0 {
            let out = from_center(point, inward, sphere.across(point, inward));
            across.add(dot(out, out).sqrt() - size);
        }
    }
    off.report();
    across.report();
    turned.report();
}

#[test]
fn planes() {
    let mut random = Random(3);
    let mut off = Seen::new("plane: hit off the surface", -28, 2.5);
    for _ in 0..CASES {
        let offset = Length::from_num(random.between(-0.7, 0.7)).to_bits().into();
        let plane = Plane::new(random.direction(), offset, None);
        let ray = random.ray();
        let near = plane.distance(&ray, Length::MAX);
        let Some(distance) = near.filter(|distance| *distance < Length::MAX) else {
            continue;
        };
        let way = times(units(ray.direction), distance.to_num());
        let height = dot(lengths(ray.origin.coordinates) + way, units(plane.normal));
        off.add(height - plane.offset as f64 * 2_f64.powi(-28));
    }
    off.report();
}

/// The center of a sphere of an upright flake, as the article defines it.
fn center_of(path: u32, radius: f64, ratio: f64) -> (Floats, f64) {
    let mut frame = [
        Vec3::new(1.0, 0.0, 0.0),
        Vec3::new(0.0, 0.0, -1.0),
        Vec3::new(0.0, 1.0, 0.0),
    ];
    let (mut center, mut radius) = (Vec3::new(0.0, 0.0, 0.0), radius);
    let mut left = path;
    while left != 0 {
        let child = (left & 15) - 1;
        // Azimuth and height of the first six; the rest are their opposites.
        let azimuth = [0.0_f64, 60.0, 120.0, 30.0, 150.0, 270.0][child as usize % 6].to_radians();
        let height = if child % 6 < 3 {
            0.0
        } else {
            (2.0_f64 / 3.0).sqrt()
        };
        let level = (1.0 - height * height).sqrt();
        let sign = if child < 6 { 1.0 } else { -1.0 };
        let d = [azimuth.cos() * level, azimuth.sin() * level, height].map(|c| c * sign);
        let [u, v, w] = frame;
        let out = times(u, d[0]) + times(v, d[1]) + times(w, d[2]);
        let turn = times(w + out, 1.0 / (1.0 + d[2]));
        frame = [u - times(turn, d[0]), v - times(turn, d[1]), out];
        center = center + times(out, (1.0 + ratio) * radius);
        radius *= ratio;
        left >>= 4;
    }
    (center, radius)
}

#[test]
fn sphereflakes() {
    let mut random = Random(4);
    let mut off = Seen::new(
        "sphereflake of depth 6: hit off its sphere, in radii",
        -16,
        1.0,
    );
    let mut turned = Seen::new("sphereflake of depth 6: normal", -16, 0.75);
    let parts = SphereflakeParams {
        center: Vec3::new(Length::ZERO, Length::ZERO, Length::ZERO),
        frame: [
            Vec3::new(Unit::ONE, Unit::ZERO, Unit::ZERO),
            Vec3::new(Unit::ZERO, Unit::ZERO, -Unit::ONE),
        ],
        radius: U0F32::from_num(0.45),
        ratio: U0F32::from_bits(0x5555_5555),
        depth: 6,
    };
    let flake = Sphereflake::new(parts);
    for _ in 0..CASES {
        let ray = random.ray();
        let Some(meeting) = flake.nearest(&ray, None, Length::MAX, &mut ()) else {
            continue;
        };
        let point = ray.at(meeting.distance());
        let (center, radius) = center_of(meeting.path, 0.45, 1.0 / 3.0);
        let out = times(lengths(point.coordinates) - center, 1.0 / radius);
        off.add(dot(out, out).sqrt() - 1.0);
        turned.add(difference(units(flake.normal(&meeting)), unit(out)));
    }
    off.report();
    turned.report();
}

#[test]
fn directions_after_a_surface() {
    let mut random = Random(5);
    let mut reflected = Seen::new("mirrored direction", -30, 3.0);
    let mut bent = Seen::new("refracted direction, sqrt(k) above 2^-10", -28, 256.0);
    for _ in 0..CASES {
        let (view, mut normal) = (random.direction(), random.direction());
        if view.cosine(normal) > 0 {
            normal = -normal;
        }
        let cosine = -view.cosine(normal);
        let (v, n) = (units(view), units(normal));
        let c = -dot(v, n);
        let exact = unit(v + times(n, 2.0 * c));
        reflected.add(difference(
            units(optics::mirrored(view, normal, cosine)),
            exact,
        ));

        let (eta, exact_eta) = length(&mut random, 0.25, 4.0);
        let k = 1.0 - exact_eta * exact_eta * (1.0 - c * c);
        let Some(direction) = optics::refracted(view, normal, cosine, eta) else {
            assert!(k < 2_f64.powi(-26), "{k}");
            continue;
        };
        if k > 2_f64.powi(-20) {
            let exact = times(v, exact_eta) + times(n, exact_eta * c - k.sqrt());
            bent.add(difference(units(direction), unit(exact)));
        }
    }
    reflected.report();
    bent.report();
}

#[test]
fn colors() {
    let mut random = Random(6);
    let mut product = Seen::new("product of two factors", -15, 0.5);
    for _ in 0..CASES {
        let mut factor = || Factor::from_num(random.between(0.0, 1.0));
        let (a, b) = (factor(), factor());
        let filtered = Color::new(a, a, a).filtered(Color::new(b, b, b)).r;
        product.add(filtered.to_num::<f64>() - a.to_num::<f64>() * b.to_num::<f64>());
    }
    product.report();
}
