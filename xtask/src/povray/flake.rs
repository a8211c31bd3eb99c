//! The spheres of a sphereflake, one by one.

use whitted_oracle::{Sphereflake, Vec3};

/// How many there are: 12 of each that is not of the last generation.
pub(super) fn count(depth: u32) -> u64 {
    (0..=depth).map(|generation| 12_u64.pow(generation)).sum()
}

/// A sphere, and how those around it lie.
struct Node {
    center: Vec3<f64>,
    radius: f64,
    frame: [Vec3<f64>; 3],
}

/// Hands each sphere's center and radius to `visit`, until that fails.
pub(super) fn each<E>(
    flake: &Sphereflake<f64>,
    visit: &mut impl FnMut(Vec3<f64>, f64) -> Result<(), E>,
) -> Result<(), E> {
    let root = Node {
        center: flake.center,
        radius: flake.radius,
        frame: flake.frame,
    };
    walk(&root, flake.ratio, flake.depth, visit)
}

fn walk<E>(
    node: &Node,
    ratio: f64,
    depth: u32,
    visit: &mut impl FnMut(Vec3<f64>, f64) -> Result<(), E>,
) -> Result<(), E> {
    visit(node.center, node.radius)?;
    if depth == 0 {
        return Ok(());
    }
    for [du, dv, dw] in directions() {
        let [u, v, w] = node.frame;
        let out = u * du + v * dv + w * dw;
        // The smallest rotation that takes w to `out`.
        let turn = (w + out) * (1.0 / (1.0 + dw));
        let child = Node {
            center: node.center + out * ((1.0 + ratio) * node.radius),
            radius: ratio * node.radius,
            frame: [u - turn * du, v - turn * dv, out],
        };
        walk(&child, ratio, depth - 1, visit)?;
    }
    Ok(())
}

/// In a sphere's (u, v, w), to its children: six around the equator, three above
/// and three below, at an elevation of atan √2.
fn directions() -> impl Iterator<Item = [f64; 3]> {
    let steep = 2.0_f64.sqrt().atan();
    let ring = |count: u32, first: f64, elevation: f64| {
        (0..count).map(move |k| {
            let azimuth = (first + f64::from(360 / count * k)).to_radians();
            let (sin, cos) = azimuth.sin_cos();
            let flat = elevation.cos();
            [flat * cos, flat * sin, elevation.sin()]
        })
    };
    ring(6, 0.0, 0.0)
        .chain(ring(3, 30.0, steep))
        .chain(ring(3, 90.0, -steep))
}

#[cfg(test)]
mod tests {
    use std::convert::Infallible;

    use whitted_oracle::{upright_frame, vec3};

    use super::*;

    /// Depth first, as they come.
    fn spheres(depth: u32) -> Vec<(Vec3<f64>, f64)> {
        let flake = Sphereflake {
            center: vec3(0.0, 150.0, 0.0),
            radius: 75.0,
            depth,
            ratio: 1.0 / 3.0,
            frame: upright_frame(),
        };
        let mut spheres = Vec::new();
        let Ok(()) = each(&flake, &mut |center, radius| {
            spheres.push((center, radius));
            Ok::<_, Infallible>(())
        });
        spheres
    }

    fn gap((a, radius): (Vec3<f64>, f64), (b, other): (Vec3<f64>, f64)) -> f64 {
        (a - b).length() - radius - other
    }

    #[test]
    fn children_touch_their_parents() {
        let spheres = spheres(2);
        assert_eq!(spheres.len() as u64, count(2));
        // After the root, each child with its twelve.
        for family in spheres[1..].chunks(13) {
            assert!(gap(spheres[0], family[0]).abs() < 1e-9);
            for grandchild in &family[1..] {
                assert!(gap(family[0], *grandchild).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn children_stand_on_their_parents_upright() {
        let spheres = spheres(2);
        for family in spheres[1..].chunks(13) {
            // The three below, seen from the child, reach into the root.
            let inside = family[1..]
                .iter()
                .filter(|sphere| gap(spheres[0], **sphere) < -1.0);
            assert_eq!(inside.count(), 3);
        }
    }
}
