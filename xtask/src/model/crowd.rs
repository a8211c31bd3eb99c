//! Crowds: many balls, with or without a floor.

use std::f64::consts::TAU;
use std::fmt::Write;

use fastrand::Rng;

/// Up to 60 balls, spread like the seeds of a sunflower, as a scene file.
pub(super) fn crowd(seed: u64) -> String {
    /// The golden angle: no two balls lie in one direction.
    const TURN: f64 = 0.381_966 * TAU;
    let mut rng = Rng::with_seed(seed);
    let mut text = format!(
        r#"max_depth = {depth}
background = [0.2, 0.3, 0.5]
camera = {{ eye = [0.0, {height:.2}, 4.0], look_at = [0.0, 0.0, 0.0], fovy_deg = 38.0 }}
[materials]
matte = {{ ka = [0.1, 0.1, 0.1], kd = [0.7, 0.6, 0.5] }}
shiny = {{ kd = [0.2, 0.3, 0.6], ks = [0.5, 0.5, 0.5], shininess = {shininess} }}
mirror = {{ ks = [0.5, 0.5, 0.5], shininess = 90, kr = [0.8, 0.8, 0.8] }}
glass = {{ kr = [0.1, 0.1, 0.1], kt = [0.9, 0.9, 0.9], ior = 1.4 }}
"#,
        depth = rng.u8(1..6),
        height = 3.0 * rng.f64(),
        shininess = rng.u8(2..200),
    );
    for _ in 0..rng.u8(1..3) {
        let [x, z] = [(); 2].map(|()| 8.0 * (rng.f64() - 0.5));
        let y = 2.0 + 3.0 * rng.f64();
        let color = "color = [0.6, 0.6, 0.6]";
        _ = write!(
            text,
            "[[lights]]\nposition = [{x:.2}, {y:.2}, {z:.2}]\n{color}\n"
        );
    }
    if rng.bool() {
        text.push_str(
            r#"[[objects]]
type = "plane"
normal = [0, 1, 0]
point = [0, -0.5, 0]
material = "matte"
"#,
        );
    }
    let count = rng.u8(2..60);
    let radius = (0.9 + 0.6 * rng.f64()) / f64::from(count).sqrt();
    let favorite = ["matte", "shiny", "mirror", "glass"][rng.usize(..4)];
    for number in 0..count {
        let way = 1.6 * (f64::from(number) / f64::from(count)).sqrt();
        let (sin, cos) = (TURN * f64::from(number)).sin_cos();
        let (x, z) = (way * cos, way * sin);
        let y = if number % 3 == 0 {
            2.0 * radius
        } else {
            radius
        } - 0.5;
        let material = ["matte", "shiny", "mirror", favorite][rng.usize(..4)];
        let ball = format!("center = [{x:.3}, {y:.3}, {z:.3}]\nradius = {radius:.3}");
        _ = write!(
            text,
            "[[objects]]\ntype = \"sphere\"\n{ball}\nmaterial = {material:?}\n"
        );
    }
    text
}
