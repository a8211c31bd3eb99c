//! What no reference image shows: gradients, endless surfaces, transparent ones
//! that enclose nothing, and where the ray tree is cut.
//!
//! The pictures are of one pixel. Against a gradient from black to white it
//! reads off the height of the direction in which its ray escaped.

use whitted_oracle::{OwnedScene, parse};

const CLEAR: &str = "[materials.clear]\nkt = [1, 1, 1]\nior = 'water'\n";

/// What a ray from `eye` along (3/5, `rise`·4/5, 0) brings back.
fn look(eye: [f64; 3], rise: f64, objects: &str) -> f64 {
    scene(eye, rise, objects).render(1, 1)[0][0]
}

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
    assert!((a - b).abs() < 1e-12, "{a} is not {b}");
}

#[test]
fn gradient_blends_by_height_and_stops_at_the_horizon() {
    assert_near(look([0.0; 3], 1.0, ""), 0.8);
    assert_near(look([0.0; 3], -1.0, ""), 0.0);
}

#[test]
fn endless_plane_is_a_water_surface() {
    let plane = "[[objects]]\ntype = 'plane'\nnormal = [0, 1, 0]\npoint = [0, 1, 0]\n\
        material = 'clear'\n";
    // From below, where the sine of the angle to the normal is 0.6, into air.
    let sine: f64 = 0.6 * 1.33;
    assert_near(look([0.0; 3], 1.0, plane), (1.0 - sine * sine).sqrt());
    let bounded = format!("{plane}bounds = {{ x = [-5, 5] }}");
    assert_near(look([0.0; 3], 1.0, &bounded), 0.8);
}

/// An upright cylinder would not show it: its normal, having no height, leaves a
/// ray's as it is.
#[test]
fn clamped_surfaces_bend_nothing_and_endless_ones_do() {
    for shape in [
        "type = 'cone'\norigin = [5, 0, 0.3]\nradius = 1\nheight = 20",
        "type = 'paraboloid'\norigin = [5, 3, 0.3]",
    ] {
        let endless = format!("[[objects]]\n{shape}\nmaterial = 'clear'\n");
        let bent = look([0.0; 3], 1.0, &endless);
        assert!((bent - 0.8).abs() > 1e-3, "{shape}: {bent}");
        let clamped = format!("{endless}y = [-40, 40]");
        assert_near(look([0.0; 3], 1.0, &clamped), 0.8);
    }
}

#[test]
fn cone_goes_on_beyond_its_apex() {
    let glow = "[materials.glow]\nle = [0.5, 0.5, 0.5]\n";
    let cone = "[[objects]]\ntype = 'cone'\norigin = [3, 0, 0]\nradius = 1\nheight = 1\n\
        material = 'glow'\n";
    // The ray passes 3 above the apex, through the upper cone, whose side it
    // meets at a height of 2.29.
    for (limits, seen) in [("", 0.5), ("y = [0, 3]", 0.5), ("y = [0, 1]", 0.8)] {
        assert_near(look([0.0; 3], 1.0, &format!("{glow}{cone}{limits}")), seen);
    }
}

#[test]
fn branches_are_cut_by_weight_and_by_budget() {
    let mirror = "[materials.dim]\nle = [0.1, 0.1, 0.1]\nkr = [0.5, 0.5, 0.5]\n\
        [[objects]]\ntype = 'plane'\nnormal = [0, 1, 0]\npoint = [0, -1, 0]\nmaterial = 'dim'\n";
    let reflected = 0.1 + 0.5 * 0.8;
    for (min_weight, ray_budget, seen) in [
        (0.0, 2, reflected),
        (0.5, 2, reflected),
        (0.51, 2, 0.1),
        (0.0, 1, 0.1),
        (0.0, 0, 0.0),
    ] {
        let mut scene = scene([0.0; 3], -1.0, mirror);
        scene.settings.min_weight = min_weight;
        scene.settings.ray_budget = ray_budget;
        assert_near(scene.render(1, 1)[0][0], seen);
    }
}
