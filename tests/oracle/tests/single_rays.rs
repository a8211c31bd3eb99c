//! Checks features that no reference image shows: gradients, unbounded surfaces,
//! transparent surfaces without interior, and the limits of the ray tree.
//!
//! Pictures have one pixel. The background is a gradient from black to white, so the
//! pixel's value is the y component of the direction in which its ray left the scene.

use whitted_oracle::{OwnedScene, parse};

const CLEAR: &str = "[materials.clear]\nkt = [1, 1, 1]\nior = 'water'\n";

/// Returns the radiance along the ray from `eye` in direction (3/5, `rise`·4/5, 0).
fn radiance(eye: [f64; 3], rise: f64, objects: &str) -> f64 {
    scene(eye, rise, objects).render(1, 1)[0][0]
}

/// Returns a scene whose camera looks from `eye` in direction (3/5, `rise`·4/5, 0).
fn scene([x, y, z]: [f64; 3], rise: f64, objects: &str) -> OwnedScene<f64> {
    let (ahead, above) = (x + 0.6, y + 0.8 * rise);
    parse(&format!(
        "background = {{ horizon = [0, 0, 0], zenith = [1, 1, 1] }}
        [camera]
        eye = [{x:?}, {y:?}, {z:?}]
        look_at = [{ahead:?}, {above:?}, {z:?}]
        fovy_deg = 40
        {CLEAR}
        {objects}"
    ))
}

fn assert_near(a: f64, b: f64) {
    assert!((a - b).abs() < 1e-12, "{a}, expected {b}");
}

#[test]
fn gradient_blends_by_height_and_stops_at_the_horizon() {
    assert_near(radiance([0.0; 3], 1.0, ""), 0.8);
    assert_near(radiance([0.0; 3], -1.0, ""), 0.0);
}

#[test]
fn unbounded_plane_refracts() {
    let plane = "[[objects]]\ntype = 'plane'\nnormal = [0, 1, 0]\npoint = [0, 1, 0]\n\
        material = 'clear'\n";
    // The ray leaves the water; the sine of its angle to the normal is 0.6.
    let sine: f64 = 0.6 * 1.33;
    assert_near(radiance([0.0; 3], 1.0, plane), (1.0 - sine * sine).sqrt());
    let bounded = format!("{plane}bounds = {{ x = [-5, 5] }}");
    assert_near(radiance([0.0; 3], 1.0, &bounded), 0.8);
}

/// Cylinders are left out: their normal has no y component, so refraction does not
/// change the y component of a direction.
#[test]
fn only_unbounded_surfaces_refract() {
    for shape in [
        "type = 'cone'\norigin = [5, 0, 0.3]\nradius = 1\nheight = 20",
        "type = 'paraboloid'\norigin = [5, 3, 0.3]",
    ] {
        let unbounded = format!("[[objects]]\n{shape}\nmaterial = 'clear'\n");
        let refracted = radiance([0.0; 3], 1.0, &unbounded);
        assert!((refracted - 0.8).abs() > 1e-3, "{shape}: {refracted}");
        let clipped = format!("{unbounded}y = [-40, 40]");
        assert_near(radiance([0.0; 3], 1.0, &clipped), 0.8);
    }
}

#[test]
fn unbounded_cone_is_double() {
    let glow = "[materials.glow]\nle = [0.5, 0.5, 0.5]\n";
    let cone = "[[objects]]\ntype = 'cone'\norigin = [3, 0, 0]\nradius = 1\nheight = 1\n\
        material = 'glow'\n";
    // The ray passes 3 above the apex and hits the upper cone at y = 2.29.
    for (limits, expected) in [("", 0.5), ("y = [0, 3]", 0.5), ("y = [0, 1]", 0.8)] {
        assert_near(
            radiance([0.0; 3], 1.0, &format!("{glow}{cone}{limits}")),
            expected,
        );
    }
}

#[test]
fn weight_and_budget_limit_the_ray_tree() {
    let mirror = "[materials.dim]\nle = [0.1, 0.1, 0.1]\nkr = [0.5, 0.5, 0.5]\n\
        [[objects]]\ntype = 'plane'\nnormal = [0, 1, 0]\npoint = [0, -1, 0]\nmaterial = 'dim'\n";
    let reflected = 0.1 + 0.5 * 0.8;
    for (min_weight, ray_budget, expected) in [
        (0.0, 2, reflected),
        (0.5, 2, reflected),
        (0.51, 2, 0.1),
        (0.0, 1, 0.1),
        (0.0, 0, 0.0),
    ] {
        let mut scene = scene([0.0; 3], -1.0, mirror);
        scene.settings.min_weight = min_weight;
        scene.settings.ray_budget = ray_budget;
        assert_near(scene.render(1, 1)[0][0], expected);
    }
}
