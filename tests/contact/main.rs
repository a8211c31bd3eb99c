//! No acne: a surface does not shadow itself where it cannot. No leaks: no
//! light gets through where surfaces touch.

#![allow(clippy::unwrap_used)]

#[path = "../common/mod.rs"]
mod common;

mod acne;
mod leaks;

use fastrand::Rng;
use whitted::observer::{Observer, RayNode};
use whitted::{Color, Real};

type Triple = [f64; 3];

/// Shadow rays that leave something of a light, and such that do not; by
/// whether the surface is seen from behind.
#[derive(Clone, Copy, Debug, Default)]
struct Shadows {
    lit: [usize; 2],
    dark: [usize; 2],
    /// Eye rays that meet nothing.
    missed: usize,
    /// Those of the surface whose node is told of next.
    next: [usize; 2],
}

impl Observer for Shadows {
    fn shadow(&mut self, _: u16, left: Option<Color<Real>>) {
        self.next[usize::from(left.is_none())] += 1;
    }

    fn node(&mut self, node: &RayNode) {
        let [lit, dark] = std::mem::take(&mut self.next);
        self.missed += usize::from(node.object.is_none());
        self.lit[usize::from(node.inside)] += lit;
        self.dark[usize::from(node.inside)] += dark;
    }
}

/// White and matte objects, in no light but that of the lamps.
fn scene(objects: &str, eye: Triple, look_at: Triple, fovy: f64, lamps: &[Triple]) -> String {
    // Never along the view.
    let up = match eye[0] == look_at[0] && eye[2] == look_at[2] {
        true => [0, 0, -1],
        false => [0, 1, 0],
    };
    let lights = lamps
        .iter()
        .map(|at| format!("{{ position = {at:?}, color = [1, 1, 1] }},"))
        .collect::<String>();
    let objects = objects
        .lines()
        .map(|object| format!("{{ {object}, material = \"white\" }},"))
        .collect::<String>();
    format!(
        r#"
max_depth = 0
ambient = [0, 0, 0]
camera = {{ eye = {eye:?}, look_at = {look_at:?}, up = {up:?}, fovy_deg = {fovy:?} }}
lights = [{lights}]
materials.white = {{ kd = [1, 1, 1] }}
objects = [{objects}]
"#
    )
}

fn shadows(text: &str, size: [u32; 2]) -> Shadows {
    common::observe(text, size, Shadows::default()).1
}

fn direction(rng: &mut Rng) -> Triple {
    loop {
        let v = [0; 3].map(|_| 2.0 * rng.f64() - 1.0);
        let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        if (0.1..=1.0).contains(&length) {
            return v.map(|c| c / length);
        }
    }
}

/// A point outside of the unit sphere, mostly near.
fn outside(rng: &mut Rng) -> Triple {
    let distance = 1.0 + 10_f64.powf(4.0 * rng.f64() - 3.0);
    direction(rng).map(|c| c * distance)
}
