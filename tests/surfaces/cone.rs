//! Cones, steep and flat, single, double and endless.

use crate::{Case, all_within, check};

/// From the front, off its center.
const FRONT: Case = Case {
    name: "front",
    camera: "eye = [1, 1.2, 4], look_at = [0, 0, 0], fovy_deg = 33",
    lights: [[3.0, 4.0, 5.0], [0.1, -0.3, 0.1]],
    object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 2, y = [0, 2]"#,
    others: "",
    bounces: 5,
    least: all_within([100.0, 100.0, 96.0]),
};

#[test]
fn cones_agree_with_the_oracle() {
    check(&[
        FRONT,
        Case {
            name: "into it from below",
            camera: "eye = [1, -4, 2], look_at = [0, 0, 0], fovy_deg = 33",
            least: all_within([99.0, 95.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "down the axis",
            camera: "eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 20",
            least: all_within([102.0, 103.0, 99.0]),
            ..FRONT
        },
        Case {
            name: "up the axis",
            camera: "eye = [0, -9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 20",
            least: all_within([99.0, 96.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "along its side",
            camera: "eye = [2, -3, 0], look_at = [0.5, 0, 0], fovy_deg = 4",
            least: all_within([99.0, 91.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "grazed",
            camera: "eye = [2.001, -3, 0], look_at = [0.5, 0, -0.05], fovy_deg = 5",
            least: all_within([99.0, 91.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "tangent",
            camera: "eye = [0.5, 0, 5], look_at = [0.5, 0, 0], fovy_deg = 2",
            least: all_within([99.0, 99.0, 90.0]),
            ..FRONT
        },
        Case {
            name: "the apex",
            camera: "eye = [0.1, 1.2, 0.5], look_at = [0, 1, 0], fovy_deg = 10",
            least: all_within([102.0, 102.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "from inside",
            camera: "eye = [0.3, -0.4, 0.2], look_at = [0, 1, -0.4], fovy_deg = 90",
            least: all_within([99.0, 93.0, 95.0]),
            ..FRONT
        },
        Case {
            name: "the rim",
            camera: "eye = [0.2, -1.3, 2], look_at = [0, -1, 0.95], fovy_deg = 10",
            least: all_within([98.0, 101.0, 93.0]),
            ..FRONT
        },
        Case {
            name: "stands on its apex",
            lights: [[3.0, 4.0, 5.0], [0.1, 0.3, 0.1]],
            object: r#"type = "cone", origin = [0, 1, 0], radius = 1, height = -2, y = [-2, 0]"#,
            least: all_within([102.0, 103.0, 95.0]),
            ..FRONT
        },
        Case {
            name: "cut off",
            object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 3, y = [0.2, 1.8]"#,
            least: all_within([101.0, 100.0, 95.0]),
            ..FRONT
        },
        Case {
            name: "a clamp far away",
            object: r#"type = "cone", origin = [0, -1001, 0], radius = 1000, height = 1002, y = [1000, 1002]"#,
            least: all_within([99.0, 100.0, 95.0]),
            ..FRONT
        },
        Case {
            name: "far away",
            camera: "eye = [80, 100, 270], look_at = [0, 0, 0], fovy_deg = 1",
            least: all_within([102.0, 102.0, 100.0]),
            ..FRONT
        },
        Case {
            name: "tiny",
            camera: "eye = [0.002, 0.003, 0.005], look_at = [0, 0, 0], fovy_deg = 33",
            object: r#"type = "cone", origin = [0, -0.001, 0], radius = 0.001, height = 0.002, y = [0, 0.002]"#,
            least: all_within([95.0, 100.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "huge",
            camera: "eye = [10000, 20000, 40000], look_at = [0, 0, 0], fovy_deg = 33",
            lights: [[30000.0, 40000.0, 50000.0], [1000.0, -3000.0, 1000.0]],
            object: r#"type = "cone", origin = [0, -10000, 0], radius = 10000, height = 20000, y = [0, 20000]"#,
            least: all_within([101.0, 101.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "flat, 1:32",
            lights: [[3.0, 4.0, 5.0], [0.1, -0.3, 0.1]],
            object: r#"type = "cone", origin = [0, 0, 0], radius = 1, height = 0.03125, y = [0, 0.03125]"#,
            least: all_within([102.0, 101.0, 100.0]),
            ..FRONT
        },
        Case {
            name: "flat, 1:1024",
            lights: [[3.0, 4.0, 5.0], [0.1, -0.3, 0.1]],
            object: r#"type = "cone", origin = [0, 0, 0], radius = 1, height = 0.0009765625, y = [0, 0.0009765625]"#,
            least: all_within([102.0, 101.0, 100.0]),
            ..FRONT
        },
        Case {
            name: "steep, 32:1",
            camera: "eye = [0.2, 0.5, 1], look_at = [0, 0.2, 0], fovy_deg = 60",
            lights: [[3.0, 4.0, 5.0], [0.01, -0.3, 0.01]],
            object: r#"type = "cone", origin = [0, -1, 0], radius = 0.0625, height = 2, y = [0, 2]"#,
            least: all_within([102.0, 102.0, 99.0]),
            ..FRONT
        },
        Case {
            name: "steep, 1024:1",
            camera: "eye = [0.01, 0, 0.02], look_at = [0, -0.01, 0], fovy_deg = 30",
            lights: [[3.0, 4.0, 5.0], [0.0001, -0.3, 0.0001]],
            object: r#"type = "cone", origin = [0, -1, 0], radius = 0.001953125, height = 2, y = [0, 2]"#,
            least: all_within([100.0, 102.0, 95.0]),
            ..FRONT
        },
        Case {
            name: "double",
            object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 1, y = [0, 2]"#,
            least: all_within([101.0, 100.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "double, through the apex",
            camera: "eye = [0.02, 0.03, 0.5], look_at = [0, 0, 0], fovy_deg = 4",
            object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 1, y = [0, 2]"#,
            least: all_within([99.0, 97.0, 93.0]),
            ..FRONT
        },
        Case {
            name: "double, down the axis",
            camera: "eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 16",
            object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 1, y = [0, 2]"#,
            least: all_within([101.0, 97.0, 94.0]),
            ..FRONT
        },
        Case {
            name: "double, from inside",
            camera: "eye = [0.1, -0.9, 0.1], look_at = [0, 1, -0.05], fovy_deg = 90",
            object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 1, y = [0, 2]"#,
            least: all_within([100.0, 99.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "double, flat, 1:1024",
            object: r#"type = "cone", origin = [0, 0, 0], radius = 1, height = 0.0009765625, y = [0, 0.001953125]"#,
            least: all_within([102.0, 101.0, 95.0]),
            ..FRONT
        },
        Case {
            name: "checkered",
            object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 2, y = [0, 2], checker = { size = 0.3, axes = "xy", materials = ["it", "other"] }"#,
            least: all_within([100.0, 101.0, 99.0]),
            ..FRONT
        },
        Case {
            name: "on a floor",
            others: r#", { type = "plane", normal = [0, 1, 0], point = [0, -1, 0], material = "other" }"#,
            least: all_within([98.0, 97.0, 95.0]),
            ..FRONT
        },
        Case {
            name: "before a mirror",
            others: r#", { type = "plane", normal = [0, 0, 1], point = [0, 0, -1.5], material = "other" }"#,
            least: all_within([99.0, 98.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "endless",
            object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 2"#,
            least: all_within([100.0, 100.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "endless, from inside",
            camera: "eye = [0.3, -0.4, 0.2], look_at = [0, -1, -0.4], fovy_deg = 90",
            object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 2"#,
            least: all_within([101.0, 99.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "endless, up from the apex",
            camera: "eye = [0, 1, 3], look_at = [0, 9, 0], fovy_deg = 60",
            object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 2"#,
            least: all_within([99.0, 98.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "endless, in a mirror",
            camera: "eye = [0, 0, 4], look_at = [0, 9, -9], fovy_deg = 40",
            object: r#"type = "cone", origin = [0, -1, 0], radius = 1, height = 2"#,
            others: r#", { type = "plane", normal = [0, 0, 1], point = [0, 0, -3], material = "other" }"#,
            least: all_within([99.0, 97.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "endless, on a floor",
            camera: "eye = [2, 3, 12], look_at = [0, 0, -8], fovy_deg = 50",
            object: r#"type = "cone", origin = [0, 0, -9], radius = 2, height = 1"#,
            others: r#", { type = "plane", normal = [0, 1, 0], point = [0, 0, 0], material = "other" }"#,
            least: all_within([99.0, 95.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "endless, its far reflection",
            camera: "eye = [1, 0.6, 6], look_at = [0, 0, -9], fovy_deg = 30",
            object: r#"type = "cone", origin = [0, 0, -9], radius = 1, height = 9"#,
            others: r#", { type = "plane", normal = [0, 1, 0], point = [0, 0, 0], material = "other" }"#,
            least: all_within([99.0, 99.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "endless, in a far mirror",
            camera: "eye = [1, 0.6, 6], look_at = [0, 0, -9], fovy_deg = 30",
            object: r#"type = "cone", origin = [2, 0, -3], radius = 0.5, height = 3"#,
            others: r#", { type = "plane", normal = [0, 0, 1], point = [0, 0, -60], material = "other" }"#,
            least: all_within([98.0, 98.0, 96.0]),
            ..FRONT
        },
        Case {
            name: "endless and steep, 1024:1",
            camera: "eye = [0.3, 0, 0.6], look_at = [0, 0.2, 0], fovy_deg = 60",
            lights: [[3.0, 4.0, 5.0], [0.01, -0.3, 0.01]],
            object: r#"type = "cone", origin = [0, -1, 0], radius = 0.1, height = 102.4"#,
            least: all_within([100.0, 100.0, 93.0]),
            ..FRONT
        },
        Case {
            name: "endless and flat, 1:1024",
            object: r#"type = "cone", origin = [0, 0, 0], radius = 1, height = 0.0009765625"#,
            least: all_within([99.0, 96.0, 98.0]),
            ..FRONT
        },
    ]);
}
