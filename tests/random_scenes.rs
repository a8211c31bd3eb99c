//! Random scenes against the double-precision oracle, which reads the same
//! scene file by itself.

#![allow(clippy::unwrap_used)]

mod common;

use std::fmt::Write;

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use whitted_oracle::compare;

/// What a random scene is made of; all lengths are in units of its world.
#[derive(Clone, Debug)]
struct World {
    /// Units of the scene file in one unit of the world.
    scale: f64,
    /// Of the world's origin, in units of the scene file.
    offset: [f64; 3],
    eye: [f64; 3],
    fovy: f64,
    lights: Vec<([f64; 3], [f64; 3])>,
    materials: Vec<Material>,
    spheres: Vec<([f64; 3], f64)>,
    floor: Floor,
    depth: u8,
    blinn: bool,
    gradient: bool,
}

#[derive(Clone, Debug)]
struct Material {
    kd: [f64; 3],
    ks: [f64; 3],
    kr: [f64; 3],
    kt: Option<([f64; 3], f64)>,
    shininess: f64,
}

#[derive(Clone, Debug)]
struct Floor {
    tilt: [f64; 2],
    checker: Option<f64>,
    bounded: bool,
}

/// Decimals short enough for both readers to agree on every bit.
fn number(low: f64, high: f64) -> impl Strategy<Value = f64> + Clone {
    (0_u32..=10_000).prop_map(move |i| low + (high - low) * f64::from(i) / 10_000.0)
}

fn vector(low: f64, high: f64) -> impl Strategy<Value = [f64; 3]> + Clone {
    let number = number(low, high);
    [number.clone(), number.clone(), number]
}

fn material() -> impl Strategy<Value = Material> {
    let some = |most| prop_oneof![Just([0.0; 3]), vector(0.05, most)];
    let kt = prop::option::of((vector(0.3, 0.95), number(1.0, 2.5)));
    (
        vector(0.0, 0.7),
        some(0.6),
        some(0.5),
        kt,
        number(1.0, 400.0),
    )
        .prop_map(|(kd, ks, kr, kt, shininess)| Material {
            kd,
            ks,
            kr,
            kt,
            shininess,
        })
}

fn world() -> impl Strategy<Value = World> {
    let sphere = (vector(-1.0, 1.0), number(0.05, 0.8));
    let light = (
        [number(-4.0, 4.0), number(1.5, 6.0), number(-2.0, 6.0)],
        vector(0.2, 0.9),
    );
    let floor = (
        [number(-0.3, 0.3), number(-0.3, 0.3)],
        prop::option::of(number(0.2, 1.5)),
        any::<bool>(),
    )
        .prop_map(|(tilt, checker, bounded)| Floor {
            tilt,
            checker,
            bounded,
        });
    let settings = (0_u8..=5, any::<bool>(), any::<bool>());
    (
        (
            prop_oneof![Just(0.05), Just(1.0), Just(37.0), Just(3000.0)],
            vector(-3.0, 3.0),
        ),
        (
            [number(-1.5, 1.5), number(-0.2, 2.0), number(2.0, 5.0)],
            number(25.0, 80.0),
        ),
        prop::collection::vec(light, 1..3),
        prop::collection::vec(material(), 3),
        prop::collection::vec(sphere, 1..6),
        floor,
        settings,
    )
        .prop_map(
            |((scale, offset), (eye, fovy), lights, materials, spheres, floor, settings)| World {
                scale,
                offset: offset.map(|c| c * scale),
                eye,
                fovy,
                lights,
                materials,
                spheres,
                floor,
                depth: settings.0,
                blinn: settings.1,
                gradient: settings.2,
            },
        )
}

impl World {
    fn point(&self, p: [f64; 3]) -> String {
        let [x, y, z] = [0, 1, 2].map(|i| p[i] * self.scale + self.offset[i]);
        format!("[{x:.8}, {y:.8}, {z:.8}]")
    }

    fn to_toml(&self) -> String {
        let mut text = String::new();
        let background = if self.gradient {
            "{ horizon = [0.5, 0.6, 0.7], zenith = [0.1, 0.2, 0.6] }"
        } else {
            "[0.1, 0.2, 0.4]"
        };
        let shading = if self.blinn { "blinn-phong" } else { "phong" };
        writeln!(
            text,
            "max_depth = {}\nmin_weight = 0\nbackground = {background}",
            self.depth
        )
        .unwrap();
        writeln!(
            text,
            "shading = \"{shading}\"\n[camera]\neye = {}",
            self.point(self.eye)
        )
        .unwrap();
        writeln!(
            text,
            "look_at = {}\nfovy_deg = {:.4}",
            self.point([0.0; 3]),
            self.fovy
        )
        .unwrap();
        for (position, color) in &self.lights {
            writeln!(
                text,
                "[[lights]]\nposition = {}\ncolor = {color:.4?}",
                self.point(*position)
            )
            .unwrap();
        }
        for (index, m) in self.materials.iter().enumerate() {
            writeln!(text, "[materials.m{index}]\nka = [0.05, 0.05, 0.05]").unwrap();
            writeln!(
                text,
                "kd = {:.4?}\nks = {:.4?}\nkr = {:.4?}",
                m.kd, m.ks, m.kr
            )
            .unwrap();
            writeln!(text, "shininess = {:.4}", m.shininess).unwrap();
            if let Some((kt, ior)) = m.kt {
                writeln!(text, "kt = {kt:.4?}\nior = {ior:.4}").unwrap();
            }
        }
        for (index, (center, radius)) in self.spheres.iter().enumerate() {
            writeln!(
                text,
                "[[objects]]\ntype = \"sphere\"\ncenter = {}",
                self.point(*center)
            )
            .unwrap();
            writeln!(
                text,
                "radius = {:.8}\nmaterial = \"m{}\"",
                radius * self.scale,
                index % 3
            )
            .unwrap();
        }
        let [x, z] = self.floor.tilt;
        writeln!(
            text,
            "[[objects]]\ntype = \"plane\"\nnormal = [{x:.4}, 1, {z:.4}]"
        )
        .unwrap();
        writeln!(text, "point = {}", self.point([0.0, -1.0, 0.0])).unwrap();
        match self.floor.checker {
            Some(size) => writeln!(
                text,
                "checker = {{ size = {:.8}, axes = \"xz\", materials = [\"m0\", \"m1\"] }}",
                size * self.scale
            ),
            None => writeln!(text, "material = \"m2\""),
        }
        .unwrap();
        if self.floor.bounded {
            let bound = |i: usize| {
                format!(
                    "[{:.8}, {:.8}]",
                    self.offset[i] - 2.5 * self.scale,
                    self.offset[i] + 3.0 * self.scale
                )
            };
            writeln!(text, "bounds = {{ x = {}, z = {} }}", bound(0), bound(2)).unwrap();
        }
        text
    }
}

proptest! {
    // The same scenes at every run.
    #![proptest_config(Config { cases: 200, rng_seed: RngSeed::Fixed(1980), failure_persistence: None, ..Config::default() })]

    /// Nearly all pixels agree; single ones at edges may flip.
    #[test]
    fn random_scenes_agree_with_the_oracle(world in world()) {
        let text = world.to_toml();
        let (width, height) = (64, 48);
        let expected = whitted_oracle::parse::<f64>(&text).render(width, height);
        let result = compare(&common::render(&text, width, height), &expected);
        println!("{:.1} dB {:.5}", result.psnr, result.within_one);
        prop_assert!(result.within_one > 0.999, "{:.2} dB, {} within 1/255\n{text}", result.psnr, result.within_one);
    }
}
