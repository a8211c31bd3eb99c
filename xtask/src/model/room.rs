//! Rooms: most of their rays meet planes, and most planes are passed by.

use std::fmt::Write;

use fastrand::Rng;

/// A room of up to six walls and four balls, as a scene file.
pub(super) fn room(seed: u64) -> String {
    let mut rng = Rng::with_seed(seed);
    let [x, y, z] = [(); 3].map(|()| 1.0 + 2.0 * rng.f64());
    let mut text = format!(
        r#"max_depth = {depth}
background = [0.2, 0.3, 0.5]
camera = {{ eye = [{eye:.2}, {up:.2}, {back:.2}], look_at = [0.0, {up:.2}, 0.0], fovy_deg = 50.0 }}
[materials]
matte = {{ ka = [0.1, 0.1, 0.1], kd = [0.7, 0.6, 0.5] }}
shiny = {{ kd = [0.2, 0.3, 0.6], ks = [0.5, 0.5, 0.5], shininess = 30, kr = [0.2, 0.2, 0.2] }}
mirror = {{ kr = [0.9, 0.9, 0.9] }}
glass = {{ kr = [0.1, 0.1, 0.1], kt = [0.9, 0.9, 0.9], ior = 1.4 }}
"#,
        depth = rng.u8(1..6),
        eye = x * (rng.f64() - 0.5),
        up = y * (0.3 + 0.4 * rng.f64()),
        back = z * 0.9,
    );
    for _ in 0..rng.u8(1..3) {
        let [right, up, back] = [x, y, z].map(|c| c * (rng.f64() - 0.5));
        let up = up + y / 2.0;
        let color = "color = [0.6, 0.6, 0.6]";
        _ = write!(
            text,
            "[[lights]]\nposition = [{right:.2}, {up:.2}, {back:.2}]\n{color}\n"
        );
    }
    let extent = [("x", -x, x), ("y", 0.0, y), ("z", -z, z)];
    for (axis, (_, low, high)) in extent.into_iter().enumerate() {
        for end in [low, high] {
            if rng.u8(..6) == 0 {
                continue;
            }
            let (mut normal, mut point) = ([0; 3], [0.0; 3]);
            normal[axis] = if rng.bool() { 1 } else { -1 };
            point[axis] = end;
            let mut bounds = extent
                .map(|(name, low, high)| format!("{name} = [{low}, {high}]"))
                .to_vec();
            bounds.remove(axis);
            let bounds = bounds.join(", ");
            let material = ["matte", "matte", "shiny", "mirror"][rng.usize(..4)];
            _ = write!(
                text,
                r#"[[objects]]
type = "plane"
normal = {normal:?}
point = {point:?}
bounds = {{ {bounds} }}
material = {material:?}
"#
            );
        }
    }
    for _ in 0..rng.u8(..5) {
        let radius = y * (0.05 + 0.2 * rng.f64());
        let [x, z] = [x, z].map(|c| c * (rng.f64() - 0.5));
        let material = ["matte", "shiny", "mirror", "glass"][rng.usize(..4)];
        let ball = format!("center = [{x:.3}, {radius:.3}, {z:.3}]\nradius = {radius:.3}");
        _ = write!(
            text,
            "[[objects]]\ntype = \"sphere\"\n{ball}\nmaterial = {material:?}\n"
        );
    }
    text
}
