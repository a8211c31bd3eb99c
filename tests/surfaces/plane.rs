//! Planes, bounded and endless.

use crate::{Case, all_within, check};

/// From the front, off its center.
const FRONT: Case = Case {
    name: "front",
    camera: "eye = [1, 1.2, 4], look_at = [0, 0, 0], fovy_deg = 33",
    lights: [[3.0, 4.0, 5.0], [0.2, -3.0, 0.1]],
    object: r#"type = "plane", normal = [0, 1, 0], point = [0, 0, 0], bounds = { x = [-1, 1], z = [-1, 1] }"#,
    others: "",
    bounces: 5,
    least: all_within([102.0, 101.0, 100.0]),
};

#[test]
fn planes_agree_with_the_oracle() {
    check(&[
        FRONT,
        Case {
            name: "grazed",
            camera: "eye = [0, 0.03, 3], look_at = [0, 0, 0], fovy_deg = 1",
            least: all_within([101.0, 99.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "along the normal",
            camera: "eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 20",
            least: all_within([101.0, 101.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "close",
            camera: "eye = [0, 0.001, 0.5], look_at = [0.2, 0, 0], fovy_deg = 60",
            least: all_within([99.0, 98.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "slanted",
            object: r#"type = "plane", normal = [0.3, 1, 0.2], point = [0, 0, 0], bounds = { x = [-1, 1], z = [-1, 1] }"#,
            least: all_within([101.0, 101.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "nearly parallel to an axis",
            object: r#"type = "plane", normal = [0.0001, 1, 0], point = [0, 0, 0], bounds = { x = [-1, 1], z = [-1, 1] }"#,
            least: all_within([102.0, 101.0, 100.0]),
            ..FRONT
        },
        Case {
            name: "the edge",
            camera: "eye = [0.3, 0.2, 2], look_at = [0, 0, 1], fovy_deg = 6",
            least: all_within([101.0, 98.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "far away",
            camera: "eye = [80, 100, 270], look_at = [0, 0, 0], fovy_deg = 1",
            least: all_within([102.0, 102.0, 102.0]),
            ..FRONT
        },
        Case {
            name: "tiny",
            camera: "eye = [0.002, 0.003, 0.005], look_at = [0, 0, 0], fovy_deg = 33",
            object: r#"type = "plane", normal = [0, 1, 0], point = [0, 0, 0], bounds = { x = [-0.001, 0.001], z = [-0.001, 0.001] }"#,
            least: all_within([102.0, 102.0, 100.0]),
            ..FRONT
        },
        Case {
            name: "huge",
            camera: "eye = [10000, 20000, 40000], look_at = [0, 0, 0], fovy_deg = 33",
            lights: [[30000.0, 40000.0, 50000.0], [2000.0, -30000.0, 1000.0]],
            object: r#"type = "plane", normal = [0, 1, 0], point = [0, 0, 0], bounds = { x = [-10000, 10000], z = [-10000, 10000] }"#,
            least: all_within([102.0, 101.0, 99.0]),
            ..FRONT
        },
        Case {
            name: "checkered",
            object: r#"type = "plane", normal = [0, 1, 0], point = [0, 0, 0], bounds = { x = [-1, 1], z = [-1, 1] }, checker = { size = 0.3, axes = "xz", materials = ["it", "other"] }"#,
            least: all_within([102.0, 102.0, 101.0]),
            ..FRONT
        },
        Case {
            name: "before a mirror",
            others: r#", { type = "plane", normal = [0, 0, 1], point = [0, 0, -1.5], material = "other" }"#,
            least: all_within([100.0, 98.0, 99.0]),
            ..FRONT
        },
        Case {
            name: "endless",
            object: r#"type = "plane", normal = [0, 1, 0], point = [0, 0, 0]"#,
            least: all_within([100.0, 96.0, 94.0]),
            ..FRONT
        },
        Case {
            name: "endless, from below",
            camera: "eye = [0, -1, 3], look_at = [0, 0, 0], fovy_deg = 60",
            object: r#"type = "plane", normal = [0, 1, 0], point = [0, 0, 0]"#,
            least: all_within([100.0, 103.0, 99.0]),
            ..FRONT
        },
        Case {
            name: "endless, up to the horizon",
            camera: "eye = [0, 0.5, 3], look_at = [0, 0.5, 0], fovy_deg = 20",
            object: r#"type = "plane", normal = [0, 1, 0], point = [0, 0, 0]"#,
            least: all_within([100.0, 97.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "endless, grazed",
            camera: "eye = [0, 0.001, 3], look_at = [0, 0.001, 0], fovy_deg = 5",
            object: r#"type = "plane", normal = [0, 1, 0], point = [0, 0, 0]"#,
            least: all_within([99.0, 98.0, 96.0]),
            ..FRONT
        },
    ]);
}
