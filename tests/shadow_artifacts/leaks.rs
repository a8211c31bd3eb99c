//! Light leaks between objects that touch.

use fastrand::Rng;

use super::{Triple, direction, outside, scene, shadows};

/// Odd sizes send a ray exactly through the center, into the seams.
const SIZES: [[u32; 2]; 3] = [[64, 64], [65, 65], [64, 48]];

/// Objects, camera and lamp, placed such that every visible point is in shadow.
struct DarkScene {
    name: &'static str,
    objects: &'static str,
    eye: Triple,
    look_at: Triple,
    fovy: f64,
    lamp: Triple,
}

#[test]
fn touching_objects_leak_no_light() {
    let mut leaks = Vec::new();
    for &DarkScene {
        name,
        objects,
        eye,
        look_at,
        fovy,
        lamp,
    } in DARK
    {
        for size in SIZES {
            let seen = shadows(&scene(objects, eye, look_at, fovy, &[lamp]), size);
            println!("{name}, {size:?}: {seen:?}");
            assert!(seen.dark != [0, 0], "{name}");
            if seen.lit != [0, 0] {
                leaks.push((name, size, seen.lit));
            }
        }
    }
    assert!(leaks.is_empty(), "{leaks:#?}");
}

const CYLINDER_ON_FLOOR: &str = r#"type = "cylinder", origin = [0, 0.1, 0], radius = 1, y = [0, 4]
type = "plane", normal = [0, 1, 0], point = [0, 0.1, 0]"#;

const DARK: &[DarkScene] = &[
    DarkScene {
        name: "a sphere on a floor, lit from above",
        objects: r#"type = "sphere", center = [0, 1, 0], radius = 1
type = "plane", normal = [0, 1, 0], point = [0, 0, 0]"#,
        eye: [0.0, 0.2, 0.9],
        look_at: [0.0, 0.0, 0.05],
        fovy: 20.0,
        lamp: [0.3, 6.0, 0.2],
    },
    DarkScene {
        name: "a cylinder on a floor, lit from outside, seen from inside",
        objects: CYLINDER_ON_FLOOR,
        eye: [0.0, 0.3, 0.0],
        look_at: [0.0, 0.1, -1.0],
        fovy: 60.0,
        lamp: [0.5, 0.2, -9.0],
    },
    DarkScene {
        name: "a cylinder on a floor, lit from inside, seen from outside",
        objects: CYLINDER_ON_FLOOR,
        eye: [0.0, 0.5, 3.0],
        look_at: [0.0, 0.1, 1.0],
        fovy: 20.0,
        lamp: [0.1, 0.7, 0.1],
    },
    DarkScene {
        name: "two touching spheres, lit along their axis",
        objects: r#"type = "sphere", center = [-1, 0, 0], radius = 1
type = "sphere", center = [1, 0, 0], radius = 1"#,
        eye: [0.1, 0.1, 0.5],
        look_at: [0.0, 0.0, 0.0],
        fovy: 20.0,
        lamp: [-5.0, 0.0, 0.0],
    },
    // The seam lies between the lamp and the visible part of the wall.
    DarkScene {
        name: "two stacked cylinders around a lamp",
        objects: r#"type = "cylinder", origin = [0, -8.3, 0], radius = 1, y = [0, 8.4]
type = "cylinder", origin = [0, 0.1, 0], radius = 1, y = [0, 8]
type = "plane", normal = [0, 0, 1], point = [0, 0, -3]"#,
        eye: [3.0, 0.1, 0.0],
        look_at: [3.0, 0.1, -3.0],
        fovy: 10.0,
        lamp: [0.2, 0.1, 0.1],
    },
];

/// Six walls form a closed box: no light from outside reaches the inside, and no
/// camera ray leaves it. The picture's diagonals run exactly into the box edges.
#[test]
fn closed_box_leaks_no_light() {
    let mut rng = Rng::with_seed(4);
    let (mut dark, mut lit, mut missed) = (0, 0, 0);
    for _ in 0..100 {
        let half = 0.5 + rng.f64();
        let center = direction(&mut rng);
        let [x, y, z] = center;
        let lamp = loop {
            let offset = outside(&mut rng);
            if offset.iter().any(|c| c.abs() > 1.0) {
                break [0, 1, 2].map(|i| center[i] + half * offset[i]);
            }
        };
        let eye = [x, y, z + 0.9 * half * rng.f64()];
        let text = scene(&walls(center, half), eye, [x, y, z - half], 90.0, &[lamp]);
        let seen = shadows(&text, [65, 65]);
        dark += seen.dark[0] + seen.dark[1];
        lit += seen.lit[0] + seen.lit[1];
        missed += seen.missed;
    }
    println!("{dark} pixels dark, {lit} lit, {missed} without a hit");
    assert!(dark > 100_000);
    assert_eq!([lit, missed], [0, 0], "pixels lit and pixels without a hit");
}

/// Returns the six walls of a cube, one per line.
fn walls(center: Triple, half: f64) -> String {
    let ends = center.map(|c| [c - half, c + half]);
    let wall = |axis: usize, side: usize| {
        let (mut normal, mut point) = ([0; 3], center);
        normal[axis] = 1;
        point[axis] = ends[axis][side];
        let bounds = [0, 1, 2]
            .into_iter()
            .filter(|other| *other != axis)
            .map(|other| format!("{} = {:?}", ["x", "y", "z"][other], ends[other]))
            .collect::<Vec<_>>()
            .join(", ");
        format!("type = \"plane\", normal = {normal:?}, point = {point:?}, bounds = {{ {bounds} }}")
    };
    [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)]
        .map(|(axis, side)| wall(axis, side))
        .join("\n")
}
