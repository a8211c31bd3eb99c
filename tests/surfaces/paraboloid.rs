//! Paraboloids, in worlds of any size.

use crate::{Case, all_within, check};

/// From the front, off its center.
const FRONT: Case = Case {
    name: "front",
    camera: "eye = [1, 1.2, 4], look_at = [0, 0, 0], fovy_deg = 33",
    lights: [[3.0, 4.0, 5.0], [0.2, 0.4, 0.1]],
    object: r#"type = "paraboloid", origin = [0, -1, 0], y = [0, 2]"#,
    others: "",
    bounces: 5,
    least: all_within([100.0, 102.0, 93.0]),
};

#[test]
fn paraboloids_agree_with_the_oracle() {
    check(&[
        FRONT,
        Case {
            name: "into it from above",
            camera: "eye = [1, 5, 2], look_at = [0, 0, 0], fovy_deg = 33",
            least: all_within([97.0, 94.0, 94.0]),
            ..FRONT
        },
        Case {
            name: "down the axis",
            camera: "eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 20",
            least: all_within([98.0, 95.0, 94.0]),
            ..FRONT
        },
        Case {
            name: "up the axis",
            camera: "eye = [0, -9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 20",
            least: all_within([100.0, 98.0, 99.0]),
            ..FRONT
        },
        Case {
            name: "parallel to the axis, at the rim",
            camera: "eye = [1.414, 9, 0], look_at = [1.414, 0, 0], up = [0, 0, -1], fovy_deg = 2",
            least: all_within([101.0, 95.0, 95.0]),
            ..FRONT
        },
        Case {
            name: "the vertex",
            camera: "eye = [0.1, -1.2, 0.5], look_at = [0, -1, 0], fovy_deg = 10",
            least: all_within([101.0, 102.0, 91.0]),
            ..FRONT
        },
        Case {
            name: "grazed",
            camera: "eye = [1.001, -2, 0], look_at = [1.0001, 0, -0.05], fovy_deg = 5",
            least: all_within([101.0, 96.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "tangent",
            camera: "eye = [1, 0, 5], look_at = [1, 0, 0], fovy_deg = 2",
            least: all_within([101.0, 102.0, 90.0]),
            ..FRONT
        },
        Case {
            name: "from inside",
            camera: "eye = [0.3, 0.1, 0.2], look_at = [1, 0.5, -1], fovy_deg = 90",
            least: all_within([97.0, 98.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "the rim",
            camera: "eye = [0.2, 1.3, 3], look_at = [0, 1, 1.4], fovy_deg = 10",
            least: all_within([96.0, 101.0, 92.0]),
            ..FRONT
        },
        Case {
            name: "a ring",
            object: r#"type = "paraboloid", origin = [0, -1, 0], y = [1, 1.5]"#,
            least: all_within([100.0, 102.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "a clamp far away",
            camera: "eye = [10, 3, 60], look_at = [0, 0, 0], fovy_deg = 60",
            object: r#"type = "paraboloid", origin = [0, -1001, 0], y = [1000, 1002]"#,
            least: all_within([100.0, 101.0, 100.0]),
            ..FRONT
        },
        Case {
            name: "far away",
            camera: "eye = [80, 100, 270], look_at = [0, 0, 0], fovy_deg = 1",
            least: all_within([101.0, 102.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "a world of 0.05",
            camera: "eye = [0.05, 0.06, 0.2], look_at = [0, 0, 0], fovy_deg = 33",
            lights: [[0.15, 0.2, 0.25], [0.001, 0.045, 0.0005]],
            object: r#"type = "paraboloid", origin = [0, -0.025, 0], y = [0, 0.05]"#,
            least: all_within([96.0, 98.0, 95.0]),
            ..FRONT
        },
        Case {
            name: "a world of 10",
            camera: "eye = [10, 12, 40], look_at = [0, 0, 0], fovy_deg = 15",
            lights: [[30.0, 40.0, 50.0], [0.2, 9.0, 0.1]],
            object: r#"type = "paraboloid", origin = [0, -5, 0], y = [0, 10]"#,
            least: all_within([101.0, 102.0, 93.0]),
            ..FRONT
        },
        Case {
            name: "a world of 10,000",
            camera: "eye = [200, 100, 400], look_at = [0, 0, 0], fovy_deg = 33",
            lights: [[30000.0, 40000.0, 50000.0], [200.0, 9000.0, 100.0]],
            object: r#"type = "paraboloid", origin = [0, -5000, 0], y = [0, 10000]"#,
            least: all_within([100.0, 101.0, 90.0]),
            ..FRONT
        },
        Case {
            name: "a world of a million",
            camera: "eye = [1500, 400, 2500], look_at = [0, 0, 0], fovy_deg = 33",
            lights: [[3000.0, 4000.0, 5000.0], [2.0, 3000.0, 1.0]],
            object: r#"type = "paraboloid", origin = [0, -500000, 0], y = [0, 1000000]"#,
            least: all_within([99.0, 100.0, 88.0]),
            ..FRONT
        },
        Case {
            name: "tiny",
            camera: "eye = [0.03, 0.015, 0.05], look_at = [0, 0, 0], fovy_deg = 33",
            lights: [[3.0, 4.0, 5.0], [0.0001, 0.0001, 0.0]],
            object: r#"type = "paraboloid", origin = [0, 0, 0], y = [0, 0.0001]"#,
            least: all_within([102.0, 102.0, 101.0]),
            ..FRONT
        },
        Case {
            name: "checkered",
            object: r#"type = "paraboloid", origin = [0, -1, 0], y = [0, 2], checker = { size = 0.3, axes = "xz", materials = ["it", "other"] }"#,
            least: all_within([101.0, 102.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "on a floor",
            others: r#", { type = "plane", normal = [0, 1, 0], point = [0, -1, 0], material = "other" }"#,
            least: all_within([99.0, 95.0, 93.0]),
            ..FRONT
        },
        Case {
            name: "before a mirror",
            others: r#", { type = "plane", normal = [0, 0, 1], point = [0, 0, -1.5], material = "other" }"#,
            least: all_within([99.0, 98.0, 94.0]),
            ..FRONT
        },
    ]);
}
