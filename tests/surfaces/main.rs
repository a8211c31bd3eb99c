//! Each surface on its own, where it is hard: against the double-precision
//! oracle, as matte, as mirror and as glass.
//!
//! `cargo test --test surfaces -- --nocapture` prints what is measured.

#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod cone;
mod cylinder;
mod ellipsoid;
mod paraboloid;
mod plane;
mod sphere;
mod sphereflake;

use whitted::observer::{Observer, RayKind, RayNode};
use whitted_oracle::compare;

const SIZE: [u32; 2] = [64, 48];

const MATERIALS: [(&str, &str); 3] = [
    (
        "matte",
        "ka = [0.1, 0.1, 0.1], kd = [0.7, 0.5, 0.4], ks = [0.3, 0.3, 0.3], shininess = 20",
    ),
    ("mirror", "kd = [0.1, 0.1, 0.2], kr = [0.8, 0.8, 0.8]"),
    (
        "glass",
        "kd = [0.1, 0.1, 0.1], kr = [0.2, 0.2, 0.2], kt = [0.8, 0.8, 0.7], ior = 1.5",
    ),
];

/// How like the oracle's picture the library's must be.
struct Least {
    /// dB.
    psnr: f64,
    /// Pixels that may be off by more than 1/255.
    off: usize,
}

/// An object, from where it is seen, and what else there is.
struct Case {
    name: &'static str,
    camera: &'static str,
    /// Mostly one outside of the object, and one inside.
    lights: [[f64; 3]; 2],
    /// Of the material `it`, unless it names another.
    object: &'static str,
    others: &'static str,
    /// Generations of rays after the eye's.
    bounces: u8,
    /// Of each of [`MATERIALS`].
    least: [Least; 3],
}

/// dB of each of [`MATERIALS`], all pixels within 1/255.
const fn all_within(psnr: [f64; 3]) -> [Least; 3] {
    let [matte, mirror, glass] = psnr;
    off(matte, 0, mirror, 0, glass, 0)
}

const fn off(m: f64, n: usize, r: f64, o: usize, g: f64, p: usize) -> [Least; 3] {
    [
        Least { psnr: m, off: n },
        Least { psnr: r, off: o },
        Least { psnr: g, off: p },
    ]
}

impl Case {
    fn toml(&self, material: &str) -> String {
        let &Self {
            camera,
            lights: [first, second],
            object,
            others,
            bounces,
            ..
        } = self;
        let cover = match object.contains("checker") {
            true => "",
            false => ", material = \"it\"",
        };
        format!(
            r#"
max_depth = {bounces}
min_weight = 0
background = {{ horizon = [0.5, 0.6, 0.7], zenith = [0.1, 0.2, 0.6] }}
camera = {{ {camera} }}
lights = [
  {{ position = {first:?}, color = [0.7, 0.7, 0.7] }},
  {{ position = {second:?}, color = [0.2, 0.1, 0.1] }},
]
materials.it = {{ {material} }}
materials.other = {{ kd = [0.2, 0.5, 0.3], ka = [0.1, 0.1, 0.1], kr = [0.3, 0.3, 0.3] }}
objects = [{{ {object}{cover} }}{others}]
"#
        )
    }
}

/// Eye rays that meet the object.
#[derive(Clone, Default)]
struct Seen(usize);

impl Observer for Seen {
    fn node(&mut self, node: &RayNode) {
        self.0 += usize::from(node.kind == RayKind::Camera && node.object == Some(0));
    }
}

/// Renders all cases, prints what is measured, and tells of all that fail.
fn check(cases: &[Case]) {
    let mut failed = Vec::new();
    for case in cases {
        for ((name, material), least) in MATERIALS.iter().zip(&case.least) {
            let toml = case.toml(material);
            let (picture, Seen(seen)) = common::observe(&toml, SIZE, Seen::default());
            let expected = whitted_oracle::parse::<f64>(&toml).render(SIZE[0], SIZE[1]);
            let result = compare(&picture, &expected);
            let off = ((1.0 - result.within_one) * picture.len() as f64).round() as usize;
            let title = format!("{}, {name}", case.name);
            println!(
                "{title:40} {:6.1} dB, {off:3} pixels off, seen by {seen:4}",
                result.psnr
            );
            if result.psnr < least.psnr || off > least.off || seen == 0 {
                failed.push(title);
            }
        }
    }
    assert!(failed.is_empty(), "{failed:#?}");
}
