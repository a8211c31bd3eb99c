//! Tests of the error bounds of the sphereflake.

#![cfg(test)]

use fastrand::Rng;
use fixed::types::U0F32;

use super::parameters::{Sphereflake, SphereflakeParams};
use crate::math::{Length, Unit, Vec3};
use crate::tests::largest_error::{Floats, LargestError, length, lengths, times, unit, units};
use crate::tests::random;

const CASES: usize = 200_000;

/// Computes the center and the radius of one sphere of an upright sphereflake in double
/// precision.
///
/// Each group of four bits in `path`, lowest first, is the number of a child, from 1 to 12.
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
        // The next lines compute the azimuth and the height of one of the first six children. The
        // other six children are opposite to these.
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
    let mut random = Rng::with_seed(4);
    let mut off = LargestError::new(
        "sphereflake of depth 6: hit off its sphere, in radii",
        -16,
        1.0,
    );
    let mut turned = LargestError::new("sphereflake of depth 6: normal", -16, 0.75);
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
        let ray = random::ray(&mut random);
        let Some(hit) = flake.nearest(&ray, None, Length::MAX, &mut ()) else {
            continue;
        };
        let point = ray.at(hit.distance());
        let (center, radius) = center_of(hit.path, 0.45, 1.0 / 3.0);
        let out = times(lengths(point.coordinates) - center, 1.0 / radius);
        off.add(length(out) - 1.0);
        turned.add(length(units(flake.normal_of(&hit)) - unit(out)));
    }
    off.check();
    turned.check();
}
