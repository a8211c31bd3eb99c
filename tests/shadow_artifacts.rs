//! Shadow acne and light leaks: a convex surface never shadows its outside, and
//! no light passes where two surfaces touch.

mod acne;
mod leaks;

use crate::common;
use fastrand::Rng;
use whitted::observer::{Observer, RayNode};
use whitted::{Color, Real};

type Triple = [f64; 3];

/// Counts of lit and shadowed light samples. Index 0 counts surfaces seen from
/// outside, index 1 surfaces seen from inside.
#[derive(Clone, Copy, Debug, Default)]
struct Shadows {
    lit: [usize; 2],
    dark: [usize; 2],
    /// Camera rays without a hit.
    missed: usize,
    /// Lit and shadowed samples of the current hit, until its node is reported.
    pending: [usize; 2],
}

impl Observer for Shadows {
    fn shadow(&mut self, _: u16, transmittance: Option<Color<Real>>) {
        self.pending[usize::from(transmittance.is_none())] += 1;
    }

    fn node(&mut self, node: &RayNode) {
        let [lit, dark] = std::mem::take(&mut self.pending);
        self.missed += usize::from(node.object.is_none());
        self.lit[usize::from(node.inside)] += lit;
        self.dark[usize::from(node.inside)] += dark;
    }
}

/// Returns a scene file of white matte objects, one per line of `objects`. The
/// lamps are its only light.
fn scene(objects: &str, eye: Triple, look_at: Triple, fovy: f64, lamps: &[Triple]) -> String {
    // `up` must not be parallel to the view direction.
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

/// Renders a scene and counts its lit and shadowed samples.
fn shadows(text: &str, size: [u32; 2]) -> Shadows {
    common::observe(text, size, Shadows::default()).1
}

/// Returns a random unit vector.
fn direction(rng: &mut Rng) -> Triple {
    loop {
        let v = [0; 3].map(|_| 2.0 * rng.f64() - 1.0);
        let length = v.iter().map(|c| c * c).sum::<f64>().sqrt();
        if (0.1..=1.0).contains(&length) {
            return v.map(|c| c / length);
        }
    }
}

/// Returns a random point outside the unit sphere, 0.001 to 10 units from it,
/// with a log-uniform distance.
fn outside(rng: &mut Rng) -> Triple {
    let distance = 1.0 + 10_f64.powf(4.0 * rng.f64() - 3.0);
    direction(rng).map(|c| c * distance)
}
