//! Self-shadowing: surfaces must not shadow themselves where their shape forbids
//! it, and must where the oracle says so.

use fastrand::Rng;

use super::{Shadows, Triple, direction, outside, scene, shadows};
use crate::common;

/// Shapes inside the unit sphere that are convex as seen from outside. Unbounded
/// shapes are convex but leave the sphere.
const CONVEX: [&str; 15] = [
    r#"type = "sphere", center = [0, 0, 0], radius = 1"#,
    r#"type = "sphereflake", center = [0, 0, 0], radius = 1, depth = 0"#,
    r#"type = "ellipsoid", center = [0, 0, 0], radii = [1, 0.6, 0.8]"#,
    r#"type = "ellipsoid", center = [0, 0, 0], radii = [1, 0.00390625, 1]"#,
    r#"type = "ellipsoid", center = [0, 0, 0], radii = [0.00390625, 1, 0.00390625]"#,
    r#"type = "cylinder", origin = [0, 0, 0], radius = 0.6, y = [-0.8, 0.8]"#,
    r#"type = "cylinder", origin = [0, 0, 0], radius = 0.01, y = [-0.9, 0.9]"#,
    r#"type = "cylinder", origin = [0, 0, 0], radius = 0.6"#,
    r#"type = "cone", origin = [0, -0.8, 0], radius = 0.6, height = 1.6, y = [0, 1.6]"#,
    r#"type = "cone", origin = [0, 0.8, 0], radius = 0.6, height = -1.6, y = [-1.4, 0]"#,
    r#"type = "cone", origin = [0, 0, 0], radius = 1, height = 0.0009765625, y = [0, 0.0009765625]"#,
    r#"type = "cone", origin = [0, -1, 0], radius = 0.001953125, height = 2, y = [0, 2]"#,
    r#"type = "paraboloid", origin = [0, -0.5, 0], y = [0, 0.7]"#,
    r#"type = "plane", normal = [0.2, 1, 0.1], point = [0, 0, 0], bounds = { x = [-0.7, 0.7], z = [-0.7, 0.7] }"#,
    r#"type = "plane", normal = [0.2, 1, 0.1], point = [0, 0, 0]"#,
];

/// A shadow ray from the outside of a convex surface to a light in front of it
/// never hits the surface again, even at grazing angles.
#[test]
fn convex_outside_has_no_acne() {
    let mut rng = Rng::with_seed(1);
    for object in CONVEX {
        let mut sum = Shadows::default();
        for _ in 0..24 {
            let lamps = [0; 16].map(|_| outside(&mut rng));
            // From 1 degree up, so that thin objects fill the picture.
            let fovy = 10_f64.powf(1.7 * rng.f64());
            let text = scene(object, outside(&mut rng), [0.0; 3], fovy, &lamps);
            let Shadows { lit, dark, .. } = shadows(&text, [64, 48]);
            sum.lit[0] += lit[0];
            sum.dark[0] += dark[0];
        }
        println!("{object}: {sum:?}");
        assert!(sum.lit[0] > 500, "{object} covers too few pixels");
        assert_eq!(sum.dark[0], 0, "{object} shadows itself");
    }
}

/// Lamps inside a closed convex surface light all of its inside; lamps outside
/// light none of it.
#[test]
fn closed_surfaces_separate_inside_from_outside() {
    let mut rng = Rng::with_seed(2);
    for (object, flat) in [
        (r#"type = "sphere", center = [0, 0, 0], radius = 1"#, 1.0),
        (
            r#"type = "sphereflake", center = [0, 0, 0], radius = 1, depth = 0"#,
            1.0,
        ),
        (
            r#"type = "ellipsoid", center = [0, 0, 0], radii = [1, 0.6, 0.8]"#,
            1.0,
        ),
        (
            r#"type = "ellipsoid", center = [0, 0, 0], radii = [1, 0.00390625, 1]"#,
            0.00390625,
        ),
        (
            r#"type = "cylinder", origin = [0, 0, 0], radius = 0.6"#,
            1.0,
        ),
    ] {
        let flattened = |[x, y, z]: Triple| [x, flat * y, z];
        let inside = |rng: &mut Rng| {
            let depth = 10_f64.powf(-3.0 * rng.f64());
            flattened(direction(rng).map(|c| 0.6 * (1.0 - depth) * c))
        };
        let outside_surface = |rng: &mut Rng| loop {
            let [x, y, z] = outside(rng);
            // Points above the unit sphere are inside the unbounded cylinder.
            if x * x + z * z > 1.0 {
                return flattened([x, y, z]);
            }
        };
        let (mut inner, mut leak) = ([0, 0], 0.0);
        for _ in 0..12 {
            let (eye, look_at) = (inside(&mut rng), inside(&mut rng));
            let view = |lamps| {
                let text = scene(object, eye, look_at, 100.0, lamps);
                common::observe(&text, [64, 48], Shadows::default())
            };
            let lamps = [0; 16].map(|_| inside(&mut rng));
            let Shadows { lit, dark, .. } = view(&lamps).1;
            inner = [inner[0] + lit[1], inner[1] + dark[1]];
            let lamps = [0; 16].map(|_| outside_surface(&mut rng));
            let picture = view(&lamps).0;
            leak = picture.into_iter().flatten().fold(leak, f64::max);
        }
        let [lit, dark] = inner;
        println!("{object}: {lit} lit, {leak:.6} leaks in");
        assert!(lit > 100_000, "{object} covers too few pixels");
        assert_eq!(dark, 0, "{object} shadows its inside");
        // At grazing incidence a crossing is off by up to the square root of a
        // position step and can be missed. The leak is below one display step.
        assert!(leak < 0.001, "light leaks into {object}");
    }
}

/// Shapes that can shadow themselves do so in the pixels in which the oracle
/// does; one pixel at a shadow's edge may differ.
#[test]
fn self_shadows_match_oracle() {
    let mut rng = Rng::with_seed(3);
    for object in [
        r#"type = "cylinder", origin = [0, 0, 0], radius = 0.6, y = [-0.8, 0.8]"#,
        r#"type = "cone", origin = [0, -0.8, 0], radius = 0.6, height = 1.6, y = [0, 1.6]"#,
        r#"type = "cone", origin = [0, -0.8, 0], radius = 0.6, height = 0.8, y = [0, 1.6]"#,
        r#"type = "cone", origin = [0, 0, 0], radius = 0.6, height = 0.8"#,
        r#"type = "cone", origin = [0, 0, 0], radius = 1, height = 0.0009765625, y = [0, 0.0019]"#,
        r#"type = "paraboloid", origin = [0, -0.5, 0], y = [0, 0.7]"#,
        r#"type = "paraboloid", origin = [0, -0.5, 0], y = [0.3, 0.7]"#,
        r#"type = "sphereflake", center = [0, 0, 0], radius = 0.5, depth = 3"#,
        r#"type = "sphereflake", center = [0, 0, 0], radius = 0.4, depth = 3, ratio = 0.5"#,
    ] {
        let (mut lit, mut wrong) = (0, 0);
        for _ in 0..48 {
            let lamp = outside(&mut rng);
            let text = scene(object, outside(&mut rng), [0.0; 3], 50.0, &[lamp]);
            let picture = common::render(&text, 64, 48);
            let expected = whitted_oracle::parse::<f64>(&text).render(64, 48);
            for ([a, ..], [b, ..]) in picture.iter().zip(&expected) {
                lit += usize::from(*a > 0.0);
                // At grazing incidence a lit pixel is black too, and cannot differ.
                wrong += usize::from((a - b).abs() > 1.0 / 255.0);
            }
        }
        println!("{object}: {lit} lit, {wrong} wrong");
        assert!(lit > 3000, "{object} covers too few pixels");
        assert!(wrong <= 1, "{object}: {wrong} pixels");
    }
}
