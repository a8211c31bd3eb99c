//! What the reference scenes do not show, against the double-precision oracle.

#![allow(clippy::unwrap_used)]

mod common;

use whitted::observer::{Observer, RayKind, ShapeKind};
use whitted::{Color, Real};
use whitted_oracle::compare;

#[track_caller]
fn agrees(text: &str) -> Vec<[f64; 3]> {
    let text = format!("min_weight = 0\n{text}");
    let (width, height) = (96, 72);
    let expected = whitted_oracle::parse::<f64>(&text).render(width, height);
    let rendered = common::render(&text, width, height);
    let result = compare(&rendered, &expected);
    println!(
        "{:.1} dB, {:.5} within 1/255",
        result.psnr, result.within_one
    );
    assert!(
        result.psnr > 60.0 && result.within_one > 0.9995,
        "{:.1} dB, {:.5} within 1/255",
        result.psnr,
        result.within_one
    );
    rendered
}

/// So many that rays meet the bounds of groups first.
#[test]
fn forty_eight_balls_reflect_each_other() {
    agrees(include_str!("../scenes/sunflower.toml"));
}

/// Planes in all directions, from both sides.
#[test]
fn a_room_is_lit_from_within() {
    agrees(include_str!("../scenes/room.toml"));
}

/// What is told of a light on its way: its tests, and then what they left of it.
#[derive(Clone, Default)]
struct Way {
    is_hidden: bool,
    filtered: u32,
    clear: u32,
}

impl Observer for Way {
    fn ray(&mut self, _: RayKind) {
        self.is_hidden = false;
    }

    fn test(&mut self, _: ShapeKind, met: bool) {
        self.is_hidden |= met;
    }

    fn shadow(&mut self, _: u16, left: Option<Color<Real>>) {
        let is_clear = left == Some(Color::gray(Real::ONE));
        assert_eq!(is_clear, !self.is_hidden, "{left:?}");
        self.filtered += u32::from(!is_clear);
        self.clear += u32::from(is_clear);
    }
}

#[test]
fn what_takes_light_away_is_told_of_as_met() {
    let scene = include_str!("../scenes/filters.toml");
    let (_, way) = common::observe(scene, [96, 72], Way::default());
    assert!(way.filtered > 500 && way.clear > 500);
}

const SPHERES: &str = r#"
[camera]
eye = [0, 1, 4]
look_at = [0, 1, 0]
fovy_deg = 60
[[lights]]
position = [-3, 4, 3]
color = [0.8, 0.8, 0.8]
[materials.red]
ka = [0.1, 0, 0]
kd = [0.8, 0.1, 0.1]
[materials.mirror]
kd = [0.1, 0.1, 0.1]
kr = [0.8, 0.8, 0.8]
[[objects]]
type = "sphere"
center = [0, 1, 0]
radius = 0.7
material = "red"
"#;

/// A mirror forty units behind all else: its points are far, and what they
/// reflect is near.
#[test]
fn a_far_mirror_shows_the_scene() {
    let spheres = SPHERES
        .replace("fovy_deg = 60", "fovy_deg = 20")
        .replace("center = [0, 1, 0]", "center = [-1.5, 1, 0]");
    let mirror = r#"
[[objects]]
type = "plane"
normal = [0, 0, 1]
point = [0, 0, -40]
material = "mirror"
"#;
    let without = agrees(&format!("background = [0.2, 0.3, 0.5]\n{spheres}{mirror}"));
    // Beside and behind the eye: seen in the mirror alone.
    for behind in [
        "type = \"sphere\"\ncenter = [3, 1, 5.2]\nradius = 1.5",
        "type = \"ellipsoid\"\ncenter = [3, 1, 5.2]\nradii = [1.2, 1.6, 1.5]",
    ] {
        let with = agrees(&format!(
            "background = [0.2, 0.3, 0.5]\n{spheres}{mirror}[[objects]]\n{behind}\nmaterial = \"red\"\n"
        ));
        let changed = with.iter().zip(&without).filter(|(a, b)| a != b).count();
        assert!(changed > 20, "{changed} pixels show what is behind the eye");
    }
}

/// From far point to far point: two endless mirrors face each other.
#[test]
fn far_mirrors_show_each_other() {
    agrees(&format!(
        r#"max_depth = 6
background = [0.2, 0.3, 0.5]
{SPHERES}
[materials.tiles_a]
kd = [0.5, 0.5, 0.5]
kr = [0.4, 0.4, 0.4]
[materials.tiles_b]
kd = [0.1, 0.1, 0.3]
kr = [0.4, 0.4, 0.4]
[[objects]]
type = "plane"
normal = [0, 0, 1]
point = [0, 0, -60]
checker = {{ size = 20, axes = "xy", materials = ["tiles_a", "tiles_b"] }}
[[objects]]
type = "plane"
normal = [0, 0.2, -1]
point = [0, 0, 50]
material = "mirror"
"#
    ));
}

#[test]
fn bright_lights_and_emission_are_brought_to_scale() {
    agrees(
        r#"
ambient = [2, 2, 2]
background = [3, 0.4, 0.2]
[camera]
eye = [0, 1, 5]
look_at = [0, 1, 0]
fovy_deg = 40
[[lights]]
position = [-3, 4, 3]
color = [7, 5, 6]
[[lights]]
position = [4, 4, 3]
color = [2, 3, 4]
[materials.dim]
kd = [0.05, 0.06, 0.07]
ka = [0.01, 0.02, 0.03]
kr = [0.2, 0.2, 0.2]
ks = [0.1, 0.1, 0.1]
shininess = 20
[materials.lamp]
le = [9, 0.5, 0.1]
[[objects]]
type = "sphere"
center = [0.6, 1, 0]
radius = 0.8
material = "dim"
[[objects]]
type = "sphere"
center = [-1, 1, 0.4]
radius = 0.5
material = "lamp"
"#,
    );
}

#[test]
fn diffuse_and_specular_colors_of_a_light_are_told_apart() {
    agrees(
        r#"
[camera]
eye = [0, 1, 5]
look_at = [0, 1, 0]
fovy_deg = 40
[[lights]]
position = [-3, 4, 3]
diffuse = [0.9, 0.1, 0.1]
specular = [0.1, 0.9, 0.2]
[materials.shiny]
kd = [0.5, 0.5, 0.5]
ks = [0.5, 0.5, 0.5]
shininess = 12.5
[[objects]]
type = "sphere"
center = [0, 1, 0]
radius = 1
material = "shiny"
"#,
    );
}

/// A pool: looked into from above, and from a sphere below its surface.
#[test]
fn an_endless_plane_bounds_water() {
    agrees(&format!(
        r#"max_depth = 6
background = {{ horizon = [0.5, 0.6, 0.7], zenith = [0.1, 0.2, 0.6] }}
{SPHERES}
[materials.water]
kt = [0.8, 0.9, 0.9]
kr = [0.1, 0.1, 0.1]
ior = "water"
[materials.bottom]
kd = [0.6, 0.5, 0.3]
[[objects]]
type = "plane"
normal = [0, 1, 0]
point = [0, 0.9, 0]
material = "water"
[[objects]]
type = "plane"
normal = [0, 1, 0]
point = [0, -1, 0]
checker = {{ size = 0.5, axes = "xz", materials = ["bottom", "red"] }}
"#
    ));
}

#[test]
fn the_ray_budget_ends_a_pixel_gracefully() {
    // Two glass spheres in each other at depth 32: without a budget, 2^33 rays.
    let text = r#"
max_depth = 32
min_weight = 0
background = [0.2, 0.3, 0.5]
[camera]
eye = [0, 0, 5]
look_at = [0, 0, 0]
fovy_deg = 20
[materials.glass]
kr = [1, 1, 1]
kt = [1, 1, 1]
ior = 1.5
[[objects]]
type = "sphere"
center = [0, 0, 0]
radius = 1
material = "glass"
[[objects]]
type = "sphere"
center = [0.1, 0, 0]
radius = 0.9
material = "glass"
"#;
    let picture = common::render(text, 8, 8);
    assert!(
        picture
            .iter()
            .any(|[r, g, b]| *r > 0.5 && *g > 0.5 && *b > 0.5)
    );
}

/// `2 n (n·V)` is then 2 long, which a direction cannot be.
#[test]
fn a_mirror_that_is_met_head_on_shows_what_is_behind_the_eye() {
    for (eye, normal, up) in [
        ([0, 0, 5], [0, 0, 1], [0, 1, 0]),
        ([0, 0, -5], [0, 0, 1], [0, 1, 0]),
        ([5, 0, 0], [1, 0, 0], [0, 1, 0]),
        ([-5, 0, 0], [-1, 0, 0], [0, 1, 0]),
        ([0, 5, 0], [0, 1, 0], [0, 0, 1]),
        ([0, -5, 0], [0, 1, 0], [0, 0, 1]),
    ] {
        let picture = common::render(
            &format!(
                r#"
background = [0.2, 0.4, 0.6]
camera = {{ eye = {eye:?}, look_at = [0, 0, 0], up = {up:?}, fovy_deg = 30 }}
materials.mirror = {{ kr = [1, 1, 1] }}
[[objects]]
type = "plane"
normal = {normal:?}
point = [0, 0, 0]
bounds = {{ x = [-1, 1], y = [-1, 1], z = [-1, 1] }}
material = "mirror"
[[objects]]
type = "plane"
normal = {normal:?}
point = {far:?}
material = "glow"
[materials.glow]
le = [0.9, 0.5, 0.1]
"#,
                far = eye.map(|c| 2 * c)
            ),
            1,
            1,
        );
        let close = picture[0]
            .iter()
            .zip([0.9, 0.5, 0.1])
            .all(|(a, b)| (a - b).abs() < 0.0001);
        assert!(close, "{eye:?}: {picture:?}");
    }
}
