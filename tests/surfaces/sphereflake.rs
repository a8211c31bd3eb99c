//! Sphereflakes of any depth, ratio and frame.

use crate::{Case, all_within, check, off};

/// From the front, off its center.
const FRONT: Case = Case {
    name: "front",
    camera: "eye = [1, 1.2, 4], look_at = [0, 0, 0], fovy_deg = 33",
    lights: [[3.0, 4.0, 5.0], [0.1, 0.15, 0.05]],
    object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.6, depth = 2"#,
    others: "",
    bounces: 5,
    least: all_within([101.0, 98.0, 91.0]),
};

#[test]
fn sphereflakes_agree_with_the_oracle() {
    check(&[
        FRONT,
        Case {
            name: "depth 0",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 1, depth = 0"#,
            least: all_within([100.0, 101.0, 90.0]),
            ..FRONT
        },
        Case {
            name: "depth 1",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.6, depth = 1"#,
            least: all_within([101.0, 101.0, 92.0]),
            ..FRONT
        },
        // More bounces among small mirrors blow a rounding up to all of the picture.
        Case {
            name: "depth 3",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.6, depth = 3"#,
            bounces: 2,
            least: all_within([101.0, 100.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "depth 4",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.6, depth = 4"#,
            bounces: 2,
            least: all_within([101.0, 99.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "ratio 0.1",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.8, depth = 3, ratio = 0.1"#,
            least: all_within([101.0, 101.0, 92.0]),
            ..FRONT
        },
        Case {
            name: "ratio 0.45",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.4, depth = 3, ratio = 0.45"#,
            bounces: 2,
            least: all_within([101.0, 101.0, 97.0]),
            ..FRONT
        },
        // Which of two coincident spheres of glass a ray meets first is up to
        // rounding: the bound is of no more use than that.
        Case {
            name: "ratio 0.5, where small spheres coincide",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.4, depth = 3, ratio = 0.5"#,
            least: off(101.0, 0, 99.0, 0, 60.0, 8),
            ..FRONT
        },
        Case {
            name: "coincident spheres, close",
            camera: "eye = [0.5, 0.1, 1.2], look_at = [0.1, -0.15, 0.6], fovy_deg = 20",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.4, depth = 3, ratio = 0.5"#,
            bounces: 1,
            least: all_within([99.0, 100.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "turned",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.6, depth = 3, frame = [[0.6, 0, 0.8], [0.64, 0.6, -0.48], [-0.48, 0.8, 0.36]]"#,
            bounces: 2,
            least: all_within([101.0, 100.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "turned, ratio 0.45",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.4, depth = 3, ratio = 0.45, frame = [[0.6, 0, 0.8], [0.64, 0.6, -0.48], [-0.48, 0.8, 0.36]]"#,
            bounces: 2,
            least: all_within([101.0, 99.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "down an axis",
            camera: "eye = [0, 9, 0], look_at = [0, 0, 0], up = [0, 0, -1], fovy_deg = 12",
            least: all_within([101.0, 93.0, 89.0]),
            ..FRONT
        },
        Case {
            name: "where spheres touch",
            camera: "eye = [0.6, 0.1, 0.5], look_at = [0.6, 0, 0], fovy_deg = 10",
            least: all_within([100.0, 91.0, 85.0]),
            ..FRONT
        },
        Case {
            name: "the smallest spheres",
            camera: "eye = [0.95, 0.8, 0.5], look_at = [0.5, 0.65, 0], fovy_deg = 5",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.6, depth = 4"#,
            bounces: 1,
            least: all_within([98.0, 99.0, 98.0]),
            ..FRONT
        },
        Case {
            name: "grazed",
            camera: "eye = [0.05, 0.602, 3], look_at = [0, 0.6, 0], fovy_deg = 4",
            least: all_within([99.0, 96.0, 86.0]),
            ..FRONT
        },
        Case {
            name: "from inside",
            camera: "eye = [0.2, 0.1, 0.2], look_at = [1, 0.3, -1], fovy_deg = 90",
            least: all_within([99.0, 88.0, 90.0]),
            ..FRONT
        },
        Case {
            name: "from inside a child",
            camera: "eye = [0.75, 0.05, 0.02], look_at = [1, 0.3, -1], fovy_deg = 90",
            lights: [[3.0, 4.0, 5.0], [0.85, 0.1, 0.05]],
            least: all_within([99.0, 88.0, 92.0]),
            ..FRONT
        },
        Case {
            name: "among the children",
            camera: "eye = [0.4, 0.75, 0.1], look_at = [0, 0.6, -0.3], fovy_deg = 90",
            lights: [[3.0, 4.0, 5.0], [0.3, 0.9, 0.3]],
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.6, depth = 3"#,
            bounces: 2,
            least: all_within([96.0, 97.0, 94.0]),
            ..FRONT
        },
        Case {
            name: "far away",
            camera: "eye = [80, 100, 270], look_at = [0, 0, 0], fovy_deg = 1",
            least: all_within([102.0, 92.0, 84.0]),
            ..FRONT
        },
        Case {
            name: "tiny",
            camera: "eye = [0.002, 0.003, 0.005], look_at = [0, 0, 0], fovy_deg = 33",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.001, depth = 1"#,
            bounces: 2,
            least: all_within([97.0, 91.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "huge",
            camera: "eye = [10000, 20000, 40000], look_at = [0, 0, 0], fovy_deg = 33",
            lights: [[30000.0, 40000.0, 50000.0], [1000.0, 1500.0, 500.0]],
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 6000, depth = 2"#,
            least: all_within([101.0, 100.0, 92.0]),
            ..FRONT
        },
        Case {
            name: "checkered",
            object: r#"type = "sphereflake", center = [0, 0, 0], radius = 0.6, depth = 2, checker = { size = 0.3, axes = "xz", materials = ["it", "other"] }"#,
            least: all_within([101.0, 100.0, 97.0]),
            ..FRONT
        },
        Case {
            name: "on a floor",
            others: r#", { type = "plane", normal = [0, 1, 0], point = [0, -0.9, 0], material = "other" }"#,
            least: all_within([98.0, 95.0, 91.0]),
            ..FRONT
        },
        Case {
            name: "before a mirror",
            others: r#", { type = "plane", normal = [0, 0, 1], point = [0, 0, -1.5], material = "other" }"#,
            least: all_within([100.0, 95.0, 92.0]),
            ..FRONT
        },
    ]);
}
