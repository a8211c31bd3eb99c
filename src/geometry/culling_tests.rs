//! Checks the 16-bit culling tests against double precision.

#![cfg(test)]

extern crate std;

use fastrand::Rng;
use std::println;

use super::bounding_sphere::BoundingSphere;
use super::cull_sphere::CullSphere;
use super::light_cone::LightCone;
use super::low_precision::{normalize_q16, to_q12, to_q16};
use crate::math::{Length, Unit, Vec3, direction};

fn point(random: &mut Rng, reach: f64) -> Vec3<Length> {
    let mut c = || Length::from_num((2.0 * random.f64() - 1.0) * reach);
    Vec3::new(c(), c(), c())
}

fn exact(v: Vec3<Length>) -> [f64; 3] {
    [v.x, v.y, v.z].map(|c| c.to_num())
}

/// Returns two distances. The first is the distance from a line to the center of a bounding
/// sphere. The second is measured along the line, from `origin` to the point that is nearest to
/// the center.
fn passes(bound: &BoundingSphere, origin: Vec3<Length>, direction: Vec3<Unit>) -> [f64; 2] {
    let (to, d) = (exact(bound.center - origin), direction);
    let d = [d.x, d.y, d.z].map(|c| c.to_num::<f64>());
    let along: f64 = to.iter().zip(d).map(|(c, d)| c * d).sum();
    let off = to.iter().zip(d).map(|(c, d)| (c - along * d).powi(2));
    [off.sum::<f64>().sqrt(), along]
}

/// Tests rays that graze a bounding sphere. The rays start inside or outside of the sphere,
/// near it or far away.
#[test]
fn culling_keeps_rays_that_hit_the_bounding_sphere() {
    let random = &mut Rng::with_seed(1);
    let (mut met, mut passed, mut false_hits) = (0, 0, 0);
    let rays = if cfg!(miri) { 300 } else { 300_000 };
    for _ in 0..rays {
        let radius = 10_f64.powf(-4.0 * random.f64());
        let bound = BoundingSphere {
            center: point(random, 1.0),
            radius: Length::from_num(radius),
        };
        let reach = [1.0, 3.5][random.usize(..2)];
        let mut origin = point(random, reach);
        if random.bool() {
            origin = bound.center + point(random, 3.0 * radius);
        }
        // Aims the ray near the center of the sphere or just inside its edge.
        let mut side = point(random, radius * 1.5);
        if random.bool() {
            let [x, y, z] = exact(bound.center - origin);
            let [u, v, w] = exact(point(random, 1.0));
            let across = [y * w - z * v, z * u - x * w, x * v - y * u];
            let length = across.iter().map(|c| c * c).sum::<f64>().sqrt();
            let rim = across.map(|c| Length::from_num(c / length * radius * 0.999));
            side = Vec3::new(rim[0], rim[1], rim[2]);
        }
        let towards = bound.center + side;
        let way = (towards - origin).map(|c| i64::from(c.to_bits()));
        let Some(direction) = direction(way) else {
            continue;
        };
        let [off, along] = passes(&bound, origin, direction);
        let from_inside = exact(bound.center - origin)
            .map(|c| c * c)
            .iter()
            .sum::<f64>()
            <= radius * radius;
        let meets = off <= radius && (along > 0.0 || from_inside);
        let around = CullSphere::new(&bound, 0);
        let sight = LightCone::new(&bound, origin, 0);
        let around = around.may_hit(to_q12(origin), to_q16(direction));
        let back = origin - towards;
        let sight = sight.may_contain(normalize_q16(
            back.map(Length::to_bits),
            back.normalized().1,
        ));
        assert!(!meets || around, "{bound:?} {origin:?} {direction:?}");
        assert!(!meets || sight, "{bound:?} {origin:?} {direction:?}");
        met += i32::from(meets);
        passed += i32::from(!around || !sight);
        false_hits += i32::from(around && sight && !meets);
    }
    println!("{met} hit, {passed} culled, {false_hits} tested without a hit");
    assert!(3 * met > rays && 10 * passed > rays);
}

#[test]
fn culling_keeps_rays_that_hit_a_member_of_a_group() {
    let random = &mut Rng::with_seed(2);
    let (mut met, mut passed) = (0, 0);
    for _ in 0..if cfg!(miri) { 300 } else { 30_000 } {
        let (middle, spread) = (point(random, 0.8), 10_f64.powf(-3.0 * random.f64()));
        let radius = Length::from_num(0.1 * spread * random.f64());
        let bounds = [(); 2].map(|()| BoundingSphere {
            center: middle + point(random, 0.2 * spread),
            radius,
        });
        let group = CullSphere::around(&bounds.map(|bound| CullSphere::new(&bound, 0)));
        let origin = point(random, 3.5);
        // Aims the ray either near the middle of the group or just inside the edge of one sphere,
        // on the side away from the other sphere.
        let mut towards = middle + point(random, 0.5 * spread);
        if random.bool() {
            let [one, other] = bounds.map(|bound| bound.center);
            let Some(away) = direction((one - other).map(|c| c.to_bits().into())) else {
                continue;
            };
            towards = one + away.times(radius - (radius >> 7));
        }
        let way = (towards - origin).map(|c| i64::from(c.to_bits()));
        let Some(direction) = direction(way) else {
            continue;
        };
        let may_meet = group.may_hit(to_q12(origin), to_q16(direction));
        let meets = bounds.iter().any(|bound| {
            let [off, along] = passes(bound, origin, direction);
            off <= bound.radius.to_num::<f64>() && along > 0.0
        });
        assert!(!meets || may_meet, "{bounds:?} {origin:?} {direction:?}");
        met += i32::from(meets);
        passed += i32::from(!may_meet);
    }
    assert!(
        5 * met > passed && 5 * passed > met,
        "{met} met, {passed} culled"
    );
}
