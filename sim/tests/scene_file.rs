//! Reads scene files into scenes.

use std::error::Error;

use whitted::scene::{Axis, ClipBox, SceneItem, SceneProblem, SpecularModel};
use whitted::{Background, Color, Light, MaterialId, Real, SceneError, Shape, Texture, Vec3};
use whitted_sim::scene_file::{self, nearest};

const FULL: &str = r#"
title = "All keys"
max_depth = 7
min_weight = 0.25
shading = "blinn-phong"
ambient = [0.5, 1, 2]
background = { horizon = [0.5, 0.5, 0.5], zenith = [0, 0, 1] }

[camera]
eye = [1, 2, 3]
look_at = [-0.5, 1e1, 1_000.25]
up = [0, 0, 1]
fovy_deg = 0x20

[[lights]]
position = [1, 2, 3]
color = [1, 1, 0.5]

[[lights]]
position = [3, 2, 1]
diffuse = [1, 0, 0]
specular = [0, 1, 0]

[materials.second-by-letter]
kt = [1, 1, 1]
ior = "diamond"

[materials.first-by-letter]
ka = [0.5, 0, 0]
kd = [0, 0.5, 0]
ks = [0, 0, 0.5]
shininess = 12
kr = [0.25, 0, 0]
kt = [0, 0.25, 0]
ior = 1.5
le = [0, 0, 0.25]
model = "phong"

[[objects]]
type = "plane"
normal = [0, 1, 0]
point = [0, -1, 0]
bounds = { x = [-5, 5], z = [-4, 4] }
checker = { size = 2, axes = "zx", materials = ["first-by-letter", "second-by-letter"] }

[[objects]]
type = "sphere"
center = [0, 1, 0]
radius = 0.5
material = "first-by-letter"
"#;

const CAMERA: &str = "camera = { eye = [0, 0, 1], look_at = [0, 0, 0], fovy_deg = 33 }\n";

fn real(literal: &str) -> Real {
    literal.parse().unwrap_or_default()
}

fn color(r: &str, g: &str, b: &str) -> Color<Real> {
    Color::new(real(r), real(g), real(b))
}

#[test]
fn reads_every_key() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("full.toml", FULL)?;
    let scene = file.scene();
    assert_eq!(file.title.as_deref(), Some("All keys"));
    assert_eq!((scene.max_depth, scene.min_weight), (7, real("0.25")));
    assert_eq!(scene.shading, SpecularModel::BlinnPhong);
    assert_eq!(scene.ambient, color("0.5", "1", "2"));
    let (horizon, zenith) = (Color::gray(real("0.5")), color("0", "0", "1"));
    assert_eq!(scene.background, Background::Gradient { horizon, zenith });
    assert_eq!(scene.camera.eye, Vec3::lit("1", "2", "3"));
    assert_eq!(scene.camera.look_at, Vec3::lit("-0.5", "10", "1000.25"));
    assert_eq!(scene.camera.up, Vec3::lit("0", "0", "1"));
    assert_eq!(scene.camera.fovy_deg, real("32"));
    let lights = [
        Light::point(Vec3::lit("1", "2", "3"), color("1", "1", "0.5")),
        Light {
            position: Vec3::lit("3", "2", "1"),
            diffuse: color("1", "0", "0"),
            specular: color("0", "1", "0"),
        },
    ];
    assert_eq!(scene.lights, lights);
    Ok(())
}

#[test]
fn numbers_materials_in_the_order_of_the_file() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("full.toml", FULL)?;
    assert_eq!(file.material_names, ["second-by-letter", "first-by-letter"]);
    let [clear, mixed] = file.materials[..] else {
        return Err("two materials".into());
    };
    assert_eq!((clear.ior, clear.shading), (real("2.417"), None));
    assert_eq!(
        (mixed.ka, mixed.kd),
        (color("0.5", "0", "0"), color("0", "0.5", "0"))
    );
    assert_eq!(
        (mixed.ks, mixed.le),
        (color("0", "0", "0.5"), color("0", "0", "0.25"))
    );
    assert_eq!(
        (mixed.kr, mixed.kt),
        (color("0.25", "0", "0"), color("0", "0.25", "0"))
    );
    assert_eq!((mixed.shininess, mixed.ior), (real("12"), real("1.5")));
    assert_eq!(mixed.shading, Some(SpecularModel::Phong));
    Ok(())
}

#[test]
fn keeps_the_order_of_objects() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("full.toml", FULL)?;
    let [floor, ball] = file.objects[..] else {
        return Err("two objects".into());
    };
    let bounds = ClipBox {
        x: Some([real("-5"), real("5")]),
        y: None,
        z: Some([real("-4"), real("4")]),
    };
    let (normal, point) = (Vec3::lit("0", "1", "0"), Vec3::lit("0", "-1", "0"));
    assert_eq!(
        floor.shape,
        Shape::Plane {
            normal,
            point,
            bounds
        }
    );
    let checker = Texture::Checker {
        size: real("2"),
        axes: [Axis::Z, Axis::X],
        materials: [MaterialId(1), MaterialId(0)],
    };
    assert_eq!(floor.texture, checker);
    let (center, radius) = (Vec3::lit("0", "1", "0"), real("0.5"));
    assert_eq!(ball.shape, Shape::Sphere { center, radius });
    assert_eq!(ball.texture, Texture::Uniform(MaterialId(1)));
    Ok(())
}

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
    let at = Vec3::lit("1", "2", "3");
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
    let turned = [
        Vec3::lit("0", "1", "0"),
        Vec3::lit("0", "0", "1"),
        Vec3::lit("1", "0", "0"),
    ];
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

#[test]
fn only_the_camera_is_required() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("least.toml", CAMERA)?;
    let scene = file.scene();
    let default = whitted::Scene::new(scene.camera);
    assert_eq!(format!("{scene:?}"), format!("{default:?}"));
    Ok(())
}

#[test]
fn rounds_decimals_to_nearest() -> Result<(), Box<dyn Error>> {
    for decimal in [
        "0.1",
        "-0.3",
        "0.0039215686",
        "2147483647.75",
        "1.3e-3",
        "1e-12",
    ] {
        let file = scene_file::parse("n.toml", &format!("min_weight = {decimal}\n{CAMERA}"))?;
        assert_eq!(file.scene().min_weight, real(decimal), "{decimal}");
    }
    Ok(())
}

#[test]
fn suggests_names_for_misspelled_ones() {
    let names = ["sphere", "plane", "blinn-phong", "kd"];
    assert_eq!(nearest("shpere", names), Some("sphere"));
    assert_eq!(nearest("Plane", names), Some("plane"));
    assert_eq!(nearest("blinn", names), Some("blinn-phong"));
    assert_eq!(nearest("torus", names), None);
    assert_eq!(nearest("", names), None);
}
