//! Spheres.

use crate::{Case, all_within, check};

/// From the front, off its center.
const FRONT: Case = Case {
    name: "front",
    camera: "eye = [1, 1.2, 4], look_at = [0, 0, 0], fovy_deg = 33",
    lights: [[3.0, 4.0, 5.0], [0.2, 0.3, 0.1]],
    object: r#"type = "sphere", center = [0, 0, 0], radius = 1"#,
    others: "",
    bounces: 5,
    least: all_within([100.0, 101.0, 90.0]),
};

#[test]
fn spheres_agree_with_the_oracle() {
    check(&[
        FRONT,
        Case {
            name: "grazed",
            camera: "eye = [0, 1.0001, 3], look_at = [0, 1, 0], fovy_deg = 5",
            least: all_within([99.0, 98.0, 90.0]),
            ..FRONT
        },
        Case {
            name: "tangent",
            camera: "eye = [1, 0, 5], look_at = [1, 0, 0], fovy_deg = 1",
            least: all_within([100.0, 99.0, 89.0]),
            ..FRONT
        },
        Case {
            name: "from inside",
            camera: "eye = [0.3, 0.1, 0.2], look_at = [1, 0.5, -1], fovy_deg = 90",
            least: all_within([99.0, 88.0, 99.0]),
            ..FRONT
        },
        Case {
            name: "close to the surface",
            camera: "eye = [0, 0, 1.001], look_at = [0.2, 0.1, 0], fovy_deg = 60",
            least: all_within([98.0, 98.0, 87.0]),
            ..FRONT
        },
        Case {
            name: "through the poles",
            camera: "eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 10",
            least: all_within([100.0, 98.0, 88.0]),
            ..FRONT
        },
        Case {
            name: "far away",
            camera: "eye = [80, 100, 270], look_at = [0, 0, 0], fovy_deg = 1",
            least: all_within([102.0, 102.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "tiny",
            camera: "eye = [0.002, 0.003, 0.005], look_at = [0, 0, 0], fovy_deg = 33",
            object: r#"type = "sphere", center = [0, 0, 0], radius = 0.001"#,
            least: all_within([100.0, 102.0, 93.0]),
            ..FRONT
        },
        Case {
            name: "huge",
            camera: "eye = [10000, 20000, 40000], look_at = [0, 0, 0], fovy_deg = 33",
            lights: [[30000.0, 40000.0, 50000.0], [2000.0, 3000.0, 1000.0]],
            object: r#"type = "sphere", center = [0, 0, 0], radius = 10000"#,
            least: all_within([101.0, 101.0, 91.0]),
            ..FRONT
        },
        Case {
            name: "far from the origin",
            camera: "eye = [100001, -49999, 30004], look_at = [100000, -50000, 30000], fovy_deg = 33",
            lights: [[100003.0, -49996.0, 30005.0], [100000.2, -49999.7, 30000.1]],
            object: r#"type = "sphere", center = [100000, -50000, 30000], radius = 1"#,
            least: all_within([100.0, 101.0, 90.0]),
            ..FRONT
        },
        Case {
            name: "checkered",
            object: r#"type = "sphere", center = [0, 0, 0], radius = 1, checker = { size = 0.3, axes = "xy", materials = ["it", "other"] }"#,
            least: all_within([101.0, 101.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "over a floor",
            others: r#", { type = "plane", normal = [0, 1, 0], point = [0, -1, 0], material = "other" }"#,
            least: all_within([98.0, 96.0, 92.0]),
            ..FRONT
        },
        Case {
            name: "before a mirror",
            others: r#", { type = "plane", normal = [0, 0, 1], point = [0, 0, -1.5], material = "other" }"#,
            least: all_within([99.0, 98.0, 93.0]),
            ..FRONT
        },
    ]);
}
