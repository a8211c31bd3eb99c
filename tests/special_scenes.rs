//! Compares scenes that no reference image covers with the double-precision
//! oracle, or with the result known by construction.

use crate::common;
use whitted::observer::{Observer, RayKind, ShapeKind};
use whitted::{Color, Real};
use whitted_oracle::compare;

/// Renders a scene of 96x72 pixels and requires 60 dB and 99.95 % of the pixels
/// within 1/255 of the oracle's.
#[track_caller]
fn assert_matches_oracle(text: &str) -> Vec<[f64; 3]> {
    let text = format!("min_weight = 0\n{text}");
    let (width, height) = (96, 72);
    let expected = whitted_oracle::parse::<f64>(&text).render(width, height);
    let rendered = common::render(&text, width, height);
    let result = compare(&rendered, &expected);
    let measured = format!(
        "{:.1} dB, {:.5} within 1/255",
        result.psnr, result.within_one
    );
    println!("{measured}");
    assert!(
        result.psnr > 60.0 && result.within_one > 0.9995,
        "{measured}"
    );
    rendered
}

/// With 48 spheres, rays are tested against the bounds of groups first.
#[test]
fn many_reflecting_spheres() {
    assert_matches_oracle(include_str!("scenes/sunflower.toml"));
}

/// The room shows planes of every orientation, from both sides.
#[test]
fn room_with_light_inside() {
    assert_matches_oracle(include_str!("scenes/room.toml"));
}

/// Checks each shadow ray: its transmittance is 1 exactly if no test reported a
/// hit. Counts attenuated and clear shadow rays.
#[derive(Clone, Default)]
struct Transmittance {
    is_hit: bool,
    attenuated: u32,
    clear: u32,
}

impl Observer for Transmittance {
    fn ray(&mut self, _: RayKind) {
        self.is_hit = false;
    }

    fn test(&mut self, _: ShapeKind, is_hit: bool) {
        self.is_hit |= is_hit;
    }

    fn shadow(&mut self, _: u16, transmittance: Option<Color<Real>>) {
        let is_clear = transmittance == Some(Color::gray(Real::ONE));
        assert_eq!(is_clear, !self.is_hit, "{transmittance:?}");
        self.attenuated += u32::from(!is_clear);
        self.clear += u32::from(is_clear);
    }
}

#[test]
fn observer_sees_hits_of_attenuated_shadow_rays() {
    let scene = include_str!("scenes/filters.toml");
    let (_, counts) = common::observe(scene, [96, 72], Transmittance::default());
    assert!(counts.attenuated > 500 && counts.clear > 500);
}

/// Light and materials of the scenes with mirrors and water.
const LIGHT_AND_MATERIALS: &str = r#"
lights = [{ position = [-3, 4, 3], color = [0.8, 0.8, 0.8] }]
materials.red = { ka = [0.1, 0, 0], kd = [0.8, 0.1, 0.1] }
materials.mirror = { kd = [0.1, 0.1, 0.1], kr = [0.8, 0.8, 0.8] }
"#;

/// Camera of the scenes with mirrors and water.
const CAMERA: &str = "camera = { eye = [0, 1, 4], look_at = [0, 1, 0], fovy_deg = 60 }";
/// Sphere in front of the mirrors, and partly under water.
const RED_SPHERE: &str =
    r#"{ type = "sphere", center = [0, 1, 0], radius = 0.7, material = "red" }"#;

/// The mirror is 40 units behind the other objects: reflected rays start in the
/// extended range and hit objects in the near range.
#[test]
fn distant_mirror_reflects_near_objects() {
    let scene = |hidden: &str| {
        format!(
            r#"
background = [0.2, 0.3, 0.5]
camera = {{ eye = [0, 1, 4], look_at = [0, 1, 0], fovy_deg = 20 }}
{LIGHT_AND_MATERIALS}
objects = [
  {{ type = "sphere", center = [-1.5, 1, 0], radius = 0.7, material = "red" }},
  {{ type = "plane", normal = [0, 0, 1], point = [0, 0, -40], material = "mirror" }},
  {hidden}
]
"#
        )
    };
    let without = assert_matches_oracle(&scene(""));
    // Beside and behind the eye, so only the mirror shows the hidden object.
    for hidden in [
        r#"{ type = "sphere", center = [3, 1, 5.2], radius = 1.5, material = "red" }"#,
        r#"{ type = "ellipsoid", center = [3, 1, 5.2], radii = [1.2, 1.6, 1.5], material = "red" }"#,
    ] {
        let with = assert_matches_oracle(&scene(hidden));
        let changed = with.iter().zip(&without).filter(|(a, b)| a != b).count();
        assert!(changed > 20, "the hidden object changes {changed} pixels");
    }
}

/// Two unbounded mirrors face each other, so that rays run from one point in the
/// extended range to another.
#[test]
fn distant_mirrors_reflect_each_other() {
    assert_matches_oracle(&format!(
        r#"
max_depth = 6
background = [0.2, 0.3, 0.5]
{CAMERA}
{LIGHT_AND_MATERIALS}
materials.tiles_a = {{ kd = [0.5, 0.5, 0.5], kr = [0.4, 0.4, 0.4] }}
materials.tiles_b = {{ kd = [0.1, 0.1, 0.3], kr = [0.4, 0.4, 0.4] }}
objects = [
  {RED_SPHERE},
  {{ type = "plane", normal = [0, 0, 1], point = [0, 0, -60], checker = {{ size = 20, axes = "xy", materials = ["tiles_a", "tiles_b"] }} }},
  {{ type = "plane", normal = [0, 0.2, -1], point = [0, 0, 50], material = "mirror" }},
]
"#
    ));
}

/// Lights, ambient light and emission above 1 are scaled down by preparing.
#[test]
fn bright_lights_and_emission() {
    assert_matches_oracle(
        r#"
ambient = [2, 2, 2]
background = [3, 0.4, 0.2]
camera = { eye = [0, 1, 5], look_at = [0, 1, 0], fovy_deg = 40 }
lights = [
  { position = [-3, 4, 3], color = [7, 5, 6] },
  { position = [4, 4, 3], color = [2, 3, 4] },
]
objects = [
  { type = "sphere", center = [0.6, 1, 0], radius = 0.8, material = "dim" },
  { type = "sphere", center = [-1, 1, 0.4], radius = 0.5, material = "lamp" },
]
[materials.dim]
kd = [0.05, 0.06, 0.07]
ka = [0.01, 0.02, 0.03]
kr = [0.2, 0.2, 0.2]
ks = [0.1, 0.1, 0.1]
shininess = 20
[materials.lamp]
le = [9, 0.5, 0.1]
"#,
    );
}

#[test]
fn light_with_different_diffuse_and_specular_colors() {
    assert_matches_oracle(
        r#"
camera = { eye = [0, 1, 5], look_at = [0, 1, 0], fovy_deg = 40 }
objects = [{ type = "sphere", center = [0, 1, 0], radius = 1, material = "shiny" }]
[[lights]]
position = [-3, 4, 3]
diffuse = [0.9, 0.1, 0.1]
specular = [0.1, 0.9, 0.2]
[materials.shiny]
kd = [0.5, 0.5, 0.5]
ks = [0.5, 0.5, 0.5]
shininess = 12.5
"#,
    );
}

/// The camera looks into a pool from above; a sphere is partly under water.
#[test]
fn unbounded_plane_as_water_surface() {
    assert_matches_oracle(&format!(
        r#"
max_depth = 6
background = {{ horizon = [0.5, 0.6, 0.7], zenith = [0.1, 0.2, 0.6] }}
{CAMERA}
{LIGHT_AND_MATERIALS}
materials.water = {{ kt = [0.8, 0.9, 0.9], kr = [0.1, 0.1, 0.1], ior = "water" }}
materials.bottom = {{ kd = [0.6, 0.5, 0.3] }}
objects = [
  {RED_SPHERE},
  {{ type = "plane", normal = [0, 1, 0], point = [0, 0.9, 0], material = "water" }},
  {{ type = "plane", normal = [0, 1, 0], point = [0, -1, 0], checker = {{ size = 0.5, axes = "xz", materials = ["bottom", "red"] }} }},
]
"#
    ));
}

/// Two intersecting glass spheres at depth 32 would need 2^33 rays per pixel
/// without the ray budget.
#[test]
fn ray_budget_limits_rays_per_pixel() {
    let text = r#"
max_depth = 32
min_weight = 0
background = [0.2, 0.3, 0.5]
camera = { eye = [0, 0, 5], look_at = [0, 0, 0], fovy_deg = 20 }
materials.glass = { kr = [1, 1, 1], kt = [1, 1, 1], ior = 1.5 }
objects = [
  { type = "sphere", center = [0, 0, 0], radius = 1, material = "glass" },
  { type = "sphere", center = [0.1, 0, 0], radius = 0.9, material = "glass" },
]
"#;
    let picture = common::render(text, 8, 8);
    assert!(picture.iter().any(|pixel| pixel.iter().all(|c| *c > 0.5)));
}

/// At normal incidence the term `2 n (n·V)` of the reflected direction has
/// length 2, more than a direction can hold.
#[test]
fn reflection_at_normal_incidence() {
    for (eye, normal, up) in [
        ([0, 0, 5], [0, 0, 1], [0, 1, 0]),
        ([0, 0, -5], [0, 0, 1], [0, 1, 0]),
        ([5, 0, 0], [1, 0, 0], [0, 1, 0]),
        ([-5, 0, 0], [-1, 0, 0], [0, 1, 0]),
        ([0, 5, 0], [0, 1, 0], [0, 0, 1]),
        ([0, -5, 0], [0, 1, 0], [0, 0, 1]),
    ] {
        let behind_eye = eye.map(|c| 2 * c);
        let text = format!(
            r#"
background = [0.2, 0.4, 0.6]
camera = {{ eye = {eye:?}, look_at = [0, 0, 0], up = {up:?}, fovy_deg = 30 }}
materials.mirror = {{ kr = [1, 1, 1] }}
materials.glow = {{ le = [0.9, 0.5, 0.1] }}
objects = [
  {{ type = "plane", normal = {normal:?}, point = [0, 0, 0], bounds = {{ x = [-1, 1], y = [-1, 1], z = [-1, 1] }}, material = "mirror" }},
  {{ type = "plane", normal = {normal:?}, point = {behind_eye:?}, material = "glow" }},
]
"#
        );
        let picture = common::render(&text, 1, 1);
        let mut channels = picture[0].iter().zip([0.9, 0.5, 0.1]);
        let is_glow = channels.all(|(a, b)| (a - b).abs() < 0.0001);
        assert!(is_glow, "{eye:?}: {picture:?}");
    }
}
