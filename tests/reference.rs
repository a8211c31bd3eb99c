//! Compares pictures with the reference images: 16-bit linear images by POV-Ray
//! 3.7 and, for `four_spheres`, by a double-precision tracer. See
//! tests/reference/README.md.
//!
//! Each limit is the measured value less a small margin, so that a loss of
//! precision fails the test.

use crate::common;
use crate::common::reference_scene;

use whitted_oracle::{compare, read_png};

/// Renders a scene at the size of its reference image. Requires a PSNR above
/// `least_psnr` dB and a share of pixels within 1/255 of at least
/// `least_within_one`.
#[track_caller]
fn check(name: &str, least_psnr: f64, least_within_one: f64) {
    let tests = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");
    let text = reference_scene::text(tests, name);
    let image = read_png(format!("{tests}/reference/images/{name}.png"));
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
    whitted: "whitted", 103.0 dB, 1.0;
    still_life: "still_life", 101.5 dB, 1.0;
    phong_terms: "phong_terms", 106.0 dB, 1.0;
    shininess_phong: "shininess_phong", 104.0 dB, 1.0;
    shininess_blinn: "shininess_blinn", 102.5 dB, 1.0;
    // The outliers are single pixels, spread over the spheres.
    glass_indices: "glass_indices", 83.0 dB, 0.9997;
    cylinder: "cylinders", 101.5 dB, 1.0;
    cone: "cones", 101.5 dB, 1.0;
    paraboloid: "paraboloids", 101.5 dB, 1.0;
    ellipsoid: "ellipsoids", 100.5 dB, 1.0;
    mirrors_depth_1: "mirrors_depth_1", 103.0 dB, 1.0;
    mirrors_depth_3: "mirrors_depth_3", 102.5 dB, 1.0;
    mirrors_depth_6: "mirrors", 102.5 dB, 1.0;
    total_internal_reflection: "total_reflection", 98.5 dB, 1.0;
    filters: "filters", 96.0 dB, 1.0;
    sphereflake_depth_1: "sphereflake_1", 102.0 dB, 1.0;
    sphereflake_depth_3: "sphereflake_3", 80.0 dB, 0.9998;
    sphereflake_depth_6: "sphereflake", 57.0 dB, 0.990;
    glass_and_mirror: "tinted_diamond", 101.0 dB, 1.0;
    four_spheres: "four_spheres", 66.0 dB, 0.9999;
    kt_plus_kd: "kt_plus_kd", 88.5 dB, 0.9998;
    emission_ambient: "emission_ambient", 101.5 dB, 1.0;
    camera_inside_glass: "camera_inside_glass", 99.5 dB, 1.0;
    backlit_phong: "backlit_phong", 103.0 dB, 1.0;
    backlit_blinn: "backlit_blinn", 103.0 dB, 1.0;
}
