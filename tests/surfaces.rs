//! Compares each surface with the double-precision oracle in difficult views:
//! as matte, mirror and glass.
//!
//! `cargo test --test all surfaces -- --nocapture` prints the PSNR and the outliers
//! of each picture.

mod case;

mod cone;
mod cylinder;
mod ellipsoid;
mod paraboloid;
mod plane;
mod sphere;
mod sphereflake;

use crate::common;
use case::Case;
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

macro_rules! surfaces {
    ($($test:ident: $surface:ident;)*) => {$(
        #[test]
        fn $test() {
            check($surface::CASES);
        }
    )*};
}

surfaces! {
    cones_match_oracle: cone;
    cylinders_match_oracle: cylinder;
    ellipsoids_match_oracle: ellipsoid;
    paraboloids_match_oracle: paraboloid;
    planes_match_oracle: plane;
    spheres_match_oracle: sphere;
    sphereflakes_match_oracle: sphereflake;
}

/// Counts the camera rays that hit the tested object.
#[derive(Clone, Default)]
struct Coverage(usize);

impl Observer for Coverage {
    fn node(&mut self, node: &RayNode) {
        self.0 += usize::from(node.kind == RayKind::Camera && node.object == Some(0));
    }
}

/// Renders every case in every material, prints the measurements, and fails
/// with a list of the pictures that miss their limits or do not show the object.
fn check(cases: &[Case]) {
    let mut failed = Vec::new();
    for case in cases {
        for ((name, material), limit) in MATERIALS.iter().zip(&case.limits) {
            let toml = case.toml(material);
            let (picture, Coverage(covered)) = common::observe(&toml, SIZE, Coverage::default());
            let expected = whitted_oracle::parse::<f64>(&toml).render(SIZE[0], SIZE[1]);
            let result = compare(&picture, &expected);
            let outliers = ((1.0 - result.within_one) * picture.len() as f64).round() as usize;
            let title = format!("{}, {name}", case.name);
            println!(
                "{title:56} {:6.1} dB, {outliers:3} outliers, object on {covered:4} pixels",
                result.psnr
            );
            if result.psnr < limit.psnr || outliers > limit.outliers || covered == 0 {
                failed.push(title);
            }
        }
    }
    assert!(failed.is_empty(), "{failed:#?}");
}
