//! Ellipsoids, flat ones above all.

use crate::{Case, all_within, check};

/// From the front, off its center.
const FRONT: Case = Case {
    name: "front",
    camera: "eye = [1, 1.2, 4], look_at = [0, 0, 0], fovy_deg = 33",
    lights: [[3.0, 4.0, 5.0], [0.2, 0.3, 0.1]],
    object: r#"type = "ellipsoid", center = [0, 0, 0], radii = [1, 0.6, 0.8]"#,
    others: "",
    bounces: 5,
    least: all_within([101.0, 102.0, 93.0]),
};

#[test]
fn ellipsoids_agree_with_the_oracle() {
    check(&[
        FRONT,
        Case {
            name: "grazed",
            camera: "eye = [0, 0.6001, 3], look_at = [0, 0.6, 0], fovy_deg = 5",
            least: all_within([99.0, 99.0, 89.0]),
            ..FRONT
        },
        Case {
            name: "tangent",
            camera: "eye = [1, 0, 5], look_at = [1, 0, 0], fovy_deg = 1",
            least: all_within([100.0, 99.0, 91.0]),
            ..FRONT
        },
        Case {
            name: "from inside",
            camera: "eye = [0.3, 0.1, 0.2], look_at = [1, 0.3, -1], fovy_deg = 90",
            least: all_within([99.0, 88.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "down an axis",
            camera: "eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 10",
            least: all_within([100.0, 99.0, 88.0]),
            ..FRONT
        },
        Case {
            name: "along another axis",
            camera: "eye = [9, 0, 0], look_at = [0, 0, 0], fovy_deg = 10",
            least: all_within([100.0, 100.0, 92.0]),
            ..FRONT
        },
        Case {
            name: "far away",
            camera: "eye = [80, 100, 270], look_at = [0, 0, 0], fovy_deg = 1",
            least: all_within([102.0, 102.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "tiny",
            camera: "eye = [0.002, 0.003, 0.005], look_at = [0, 0, 0], fovy_deg = 33",
            object: r#"type = "ellipsoid", center = [0, 0, 0], radii = [0.001, 0.0006, 0.0008]"#,
            least: all_within([99.0, 102.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "huge",
            camera: "eye = [10000, 20000, 40000], look_at = [0, 0, 0], fovy_deg = 33",
            lights: [[30000.0, 40000.0, 50000.0], [2000.0, 3000.0, 1000.0]],
            object: r#"type = "ellipsoid", center = [0, 0, 0], radii = [10000, 6000, 8000]"#,
            least: all_within([101.0, 102.0, 94.0]),
            ..FRONT
        },
        Case {
            name: "a lens, 1:16",
            lights: [[3.0, 4.0, 5.0], [0.2, 0.02, 0.1]],
            object: r#"type = "ellipsoid", center = [0, 0, 0], radii = [1, 0.0625, 1]"#,
            least: all_within([102.0, 101.0, 95.0]),
            ..FRONT
        },
        Case {
            name: "a disk, 1:256",
            lights: [[3.0, 4.0, 5.0], [0.2, 0.002, 0.1]],
            object: r#"type = "ellipsoid", center = [0, 0, 0], radii = [1, 0.00390625, 1]"#,
            least: all_within([102.0, 101.0, 96.0]),
            ..FRONT
        },
        // The normal turns within 2^-16 of a unit, a thousand steps of a position.
        Case {
            name: "the disk from its edge",
            camera: "eye = [0.3, 0.02, 4], look_at = [0, 0, 0], fovy_deg = 1",
            lights: [[3.0, 4.0, 5.0], [0.2, 0.002, 0.1]],
            object: r#"type = "ellipsoid", center = [0, 0, 0], radii = [1, 0.00390625, 1]"#,
            least: all_within([81.0, 73.0, 86.0]),
            ..FRONT
        },
        Case {
            name: "the disk from within",
            camera: "eye = [0, 0.001, 0.5], look_at = [0.3, 0, -1], fovy_deg = 90",
            lights: [[3.0, 4.0, 5.0], [0.2, 0.002, 0.1]],
            object: r#"type = "ellipsoid", center = [0, 0, 0], radii = [1, 0.00390625, 1]"#,
            least: all_within([102.0, 86.0, 99.0]),
            ..FRONT
        },
        Case {
            name: "a needle, 1:256",
            camera: "eye = [0.05, 0.03, 1.1], look_at = [0, 0, 0.9], fovy_deg = 10",
            lights: [[3.0, 4.0, 5.0], [0.001, 0.001, 0.2]],
            object: r#"type = "ellipsoid", center = [0, 0, 0], radii = [0.00390625, 0.00390625, 1]"#,
            least: all_within([102.0, 102.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "checkered",
            object: r#"type = "ellipsoid", center = [0, 0, 0], radii = [1, 0.6, 0.8], checker = { size = 0.3, axes = "xz", materials = ["it", "other"] }"#,
            least: all_within([101.0, 102.0, 99.0]),
            ..FRONT
        },
        Case {
            name: "over a floor",
            others: r#", { type = "plane", normal = [0, 1, 0], point = [0, -0.6, 0], material = "other" }"#,
            least: all_within([98.0, 97.0, 93.0]),
            ..FRONT
        },
        Case {
            name: "before a mirror",
            others: r#", { type = "plane", normal = [0, 0, 1], point = [0, 0, -1.5], material = "other" }"#,
            least: all_within([100.0, 99.0, 94.0]),
            ..FRONT
        },
    ]);
}
