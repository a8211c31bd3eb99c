//! Tests of the error bounds of ellipsoids, cylinders, cones and paraboloids.

#![cfg(test)]

use fastrand::Rng;
use fixed::types::I8F56;

use super::super::primitive::{Primitive, PrimitivePart};
use super::cone::Cone;
use super::cylinder::Cylinder;
use super::ellipsoid::Ellipsoid;
use super::paraboloid::Paraboloid;
use super::{Form, Quadric};
use crate::math::{Length, Unit, Vec3};
use crate::tests::largest_error::{Floats, LargestError, dot, length, lengths, times, unit, units};
use crate::tests::random;
use crate::tests::random::{between, random_length};

const CASES: usize = 200_000;

/// Measures two errors for random rays: the distance of a hit from the exact surface, and the
/// deviation of the computed normal from the exact normal.
///
/// `names` and `bounds` have one entry for each of the two errors. `make` returns a random quadric
/// and its dimensions. `function` returns the value and the gradient of the quadric's implicit
/// function at a point. `conditioning` returns a factor that depends on the direction of the ray.
/// The error of the hit is multiplied by this factor and then compared with its bound.
fn quadric(
    seed: u64,
    names: [&'static str; 2],
    bounds: [f64; 2],
    mut make: impl FnMut(&mut Rng) -> (Quadric, [f64; 3]),
    function: impl Fn(Floats, [f64; 3]) -> (f64, Floats),
    conditioning: impl Fn(Floats) -> f64,
) {
    let mut random = Rng::with_seed(seed);
    let mut off = LargestError::new(names[0], -28, bounds[0]);
    let mut turned = LargestError::new(names[1], -28, bounds[1]);
    for _ in 0..CASES {
        let (quadric, size) = make(&mut random);
        let ray = random::ray(&mut random);
        let Some(distance) = quadric.nearest(&ray, false).and_then(|t| t.near()) else {
            continue;
        };
        let way = times(units(ray.direction), distance.to_num());
        let exact = lengths(ray.origin.coordinates) + way - lengths(quadric.center);
        let (value, gradient) = function(exact, size);
        let steepness = length(gradient);
        // Ignores a hit near the apex of a cone, because there is no normal. Also ignores a hit
        // farther than sqrt(3) from the center, because a prepared cone does not reach that far.
        if steepness < 0.005 || dot(exact, exact) > 3.0 {
            continue;
        }
        off.add(value / steepness * conditioning(units(ray.direction)));

        let point = ray.at(distance);
        let (_, gradient) = function(lengths(point.coordinates - quadric.center), size);
        turned.add(length(
            units(quadric.surface_at(&point, &PrimitivePart::default()).normal) - unit(gradient),
        ));
    }
    off.check();
    turned.check();
}

/// Returns a random interval of y around the center. It serves as the clamp of a quadric.
fn clamp(random: &mut Rng, center: Vec3<Length>) -> Option<[Length; 2]> {
    let half = Length::from_num(between(random, 0.05, 0.5));
    Some([center.y - half, center.y + half])
}

#[test]
fn ellipsoids() {
    quadric(
        1,
        ["ellipsoid: hit off the surface", "ellipsoid: normal"],
        [16.0, 50.0],
        |random| {
            let radii = [0; 3].map(|_| between(random, 0.05, 0.5));
            let shortest = radii.iter().copied().fold(1.0, f64::min);
            let [a, b, c] = radii.map(|radius| Unit::from_num(shortest / radius));
            let form = Ellipsoid {
                axis_scale: Vec3::new(a, b, c),
                radius: Length::from_num(shortest),
            };
            // Radii of the ellipsoid after the rounding of its fields.
            let sizes = [a, b, c].map(|k| form.radius.to_num::<f64>() / k.to_num::<f64>());
            let center = random::point(random, 0.5);
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
        |_| 1.0,
    );
}

/// The error of a hit depends on the angle between the ray and the axis of the cylinder. If the
/// sine of this angle is below 1/8, the error grows with the reciprocal of the sine.
#[test]
fn cylinders() {
    quadric(
        1,
        ["cylinder: hit off the surface", "cylinder: normal"],
        [4.0, 0.5],
        |random| {
            let (radius, size) = random_length(random, 0.02, 0.5);
            let center = random::point(random, 0.5);
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
        |d| f64::min(1.0, 8.0 * d.x.hypot(d.z)),
    );
}

#[test]
fn cones() {
    quadric(
        1,
        ["cone: hit off the surface", "cone: normal"],
        [400.0, 160.0],
        |random| {
            let slope = 10_f64.powf(between(random, -1.0, 1.0));
            let steep = |k: f64| Unit::from_num(k.min(1.0) / 2.0);
            let (radial, axial) = (steep(1.0 / slope), steep(slope));
            let (radius, size) = random_length(random, -0.2, 0.2);
            let center = random::point(random, 0.5);
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
        |_| 1.0,
    );
}

#[test]
fn paraboloids() {
    quadric(
        1,
        ["paraboloid: hit off the surface", "paraboloid: normal"],
        [4.0, 0.5],
        |random| {
            let g_log2 = between(random, 0.0, 6.0) as u8;
            let squared = between(random, 0.01, 0.2);
            let center = random::point(random, 0.5);
            let clamp = clamp(random, center);
            let form = Form::Paraboloid(Paraboloid {
                radius_squared: I8F56::from_num(squared),
                shift: 0,
                g_log2,
            });
            let sizes = [squared, 2_f64.powi(-i32::from(g_log2)), 0.0];
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
        |_| 1.0,
    );
}
