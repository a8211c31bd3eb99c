//! Compares pictures with the reference images: 16-bit linear images by POV-Ray
//! 3.7 and, for `ftb`, by a double-precision tracer. See
//! tests/reference/README.md.
//!
//! Each limit is the measured value less a small margin, so that a loss of
//! precision fails the test.

#![allow(clippy::unwrap_used)]

mod common;

use std::fs;

use whitted_oracle::{compare, read_png};

/// Renders a scene at the size of its reference image. Requires a PSNR above
/// `least_psnr` dB and a share of pixels within 1/255 of at least
/// `least_within_one`.
#[track_caller]
fn check(name: &str, least_psnr: f64, least_within_one: f64) {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/reference");
    let text = fs::read_to_string(format!("{folder}/scenes/{name}.toml")).unwrap();
    let image = read_png(format!("{folder}/images/{name}.png"));
    let rendered = common::render(&text, image.width, image.height);
    let result = compare(&rendered, &image.pixels);
    println!(
        "{name}: {:.1} dB, {:.3} % within 1/255",
        result.psnr,
        100.0 * result.within_one
    );
    assert!(result.psnr > least_psnr, "{name}: {:.2} dB", result.psnr);
    assert!(
        result.within_one >= least_within_one,
        "{name}: {:.5} within 1/255",
        result.within_one
    );
}

macro_rules! references {
    ($($test:ident: $name:literal, $psnr:literal dB, $within:literal;)*) => {$(
        #[test]
        fn $test() {
            check($name, $psnr, $within);
        }
    )*};
}

references! {
    whitted: "01_whitted", 103.0 dB, 1.0;
    still_life: "02_still_life", 101.5 dB, 1.0;
    phong_terms: "03_phong_terms", 106.0 dB, 1.0;
    shininess_phong: "04_shininess_phong", 104.0 dB, 1.0;
    shininess_blinn: "05_shininess_blinn", 102.5 dB, 1.0;
    // The outliers are single pixels, spread over the spheres.
    glass_indices: "11_glass_indices", 83.0 dB, 0.9997;
    cylinder: "06_cylinder", 101.5 dB, 1.0;
    cone: "07_cone", 101.5 dB, 1.0;
    paraboloid: "08_paraboloid", 101.5 dB, 1.0;
    ellipsoid: "09_ellipsoid", 100.5 dB, 1.0;
    mirrors_depth_1: "10_mirrors_d1", 103.0 dB, 1.0;
    mirrors_depth_3: "10_mirrors_d3", 102.5 dB, 1.0;
    mirrors_depth_6: "10_mirrors_d6", 102.5 dB, 1.0;
    total_internal_reflection: "11b_tir_ellipsoids", 98.5 dB, 1.0;
    filters: "12_filters", 96.0 dB, 1.0;
    sphereflake_depth_1: "13_flake_d1", 102.0 dB, 1.0;
    sphereflake_depth_3: "13_flake_d3", 80.0 dB, 0.9998;
    sphereflake_depth_6: "13_flake_d6", 57.0 dB, 0.990;
    glass_and_mirror: "t10_tir_kt_kr", 101.0 dB, 1.0;
    four_spheres: "ftb", 66.0 dB, 0.9999;
    kt_plus_kd: "t06_kt_plus_kd", 88.5 dB, 0.9998;
    emission_ambient: "t13_emission_ambient", 101.5 dB, 1.0;
    camera_inside_glass: "t15_camera_inside_glass", 99.5 dB, 1.0;
    backlit_phong: "t18_backlit_phong", 103.0 dB, 1.0;
    backlit_blinn: "t19_backlit_blinn", 103.0 dB, 1.0;
}
