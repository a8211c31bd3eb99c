//! Reads objects of every type, and finds the lines of their keys.

use std::error::Error;

use whitted::scene::{SceneItem, SceneProblem};
use whitted::{SceneError, Shape, Vec3, vec3};
use whitted_sim::scene_file;

use crate::real;

const SHAPES: &str = r#"
camera = { eye = [0, 0, 1], look_at = [0, 0, 0], fovy_deg = 33 }

[materials]
a = { kd = [1, 1, 1] }

[[objects]]
type = "ellipsoid"
center = [1, 2, 3]
radii = [4, 5, 6]
material = "a"

[[objects]]
type = "cylinder"
origin = [1, 2, 3]
radius = 4
material = "a"

[[objects]]
type = "cylinder"
origin = [1, 2, 3]
radius = 4
y = [-5, 6]
material = "a"

[[objects]]
type = "cone"
origin = [1, 2, 3]
radius = 4
height = 5
material = "a"

[[objects]]
type = "cone"
origin = [1, 2, 3]
radius = 4
height = -5
y = [-6, 7]
material = "a"

[[objects]]
type = "paraboloid"
origin = [1, 2, 3]
y = [4, 5]
material = "a"

[[objects]]
type = "sphereflake"
center = [1, 2, 3]
radius = 4
depth = 5
material = "a"

[[objects]]
type = "sphereflake"
center = [1, 2, 3]
radius = 4
depth = 5
ratio = 0.333333333
frame = [
    [0, 1, 0],
    [0, 0, 1],
    [1, 0, 0],
]
material = "a"
"#;

#[test]
fn reads_every_shape() -> Result<(), Box<dyn Error>> {
    let at = vec3!(1, 2, 3);
    let [four, five, six, seven] = ["4", "5", "6", "7"].map(real);
    let flake = |ratio, frame| Shape::Sphereflake {
        center: at,
        radius: four,
        depth: 5,
        ratio,
        frame,
    };
    let cylinder = |y| Shape::Cylinder {
        origin: at,
        radius: four,
        y,
    };
    let cone = |height, y| Shape::Cone {
        origin: at,
        radius: four,
        height,
        y,
    };
    let turned = [vec3!(0, 1, 0), vec3!(0, 0, 1), vec3!(1, 0, 0)];
    let expected = [
        Shape::Ellipsoid {
            center: at,
            radii: Vec3::new(four, five, six),
        },
        cylinder(None),
        cylinder(Some([-five, six])),
        cone(five, None),
        cone(-five, Some([-six, seven])),
        Shape::Paraboloid {
            origin: at,
            y: [four, five],
        },
        flake(Shape::FLAKE_RATIO, Shape::FLAKE_FRAME),
        // The written ratio is kept; it differs from 1/3.
        flake(real("0.333333333"), turned),
    ];
    let file = scene_file::parse("shapes.toml", SHAPES)?;
    let shapes: Vec<_> = file.objects.iter().map(|object| object.shape).collect();
    assert_eq!(shapes, expected);
    Ok(())
}

/// Errors of the library about a shape's field get the line of its key.
#[test]
fn finds_the_line_of_every_field_of_a_shape() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("shapes.toml", SHAPES)?;
    let range = SceneProblem::OutOfRange {
        least: real("0"),
        most: real("1"),
    };
    let cases = [
        (0, "center", range, 9, "must be from 0 to 1, not [1, 2, 3]"),
        (0, "radii", range, 10, "must be from 0 to 1, not [4, 5, 6]"),
        (1, "origin", range, 15, "must be from 0 to 1, not [1, 2, 3]"),
        (1, "radius", range, 16, "must be from 0 to 1, not 4"),
        // A key left to its default has the line of the object.
        (1, "y", range, 13, "must be from 0 to 1"),
        (
            2,
            "y",
            SceneProblem::EmptyInterval,
            23,
            "must run from a lower to a higher value",
        ),
        (3, "height", range, 30, "must be from 0 to 1, not 5"),
        (4, "y", range, 38, "must be from 0 to 1, not [-6, 7]"),
        (5, "y", range, 44, "must be from 0 to 1, not [4, 5]"),
        (7, "depth", range, 58, "must be from 0 to 1, not 5"),
        (
            7,
            "ratio",
            range,
            59,
            "must be from 0 to 1, not 0.333333333",
        ),
        (
            7,
            "frame",
            SceneProblem::NotOrthonormal,
            60,
            "must be three unit vectors at right angles, u × v = w",
        ),
    ];
    for (object, field, problem, line, reason) in cases {
        let item = SceneItem::Object(object);
        let error = file.explain(SceneError {
            item,
            field,
            problem,
        });
        let key = format!("objects[{object}].{field}");
        assert_eq!((error.line, error.key), (Some(line), Some(key)));
        assert_eq!(error.reason, reason);
        assert!(error.help.is_some(), "{field}");
    }
    Ok(())
}
