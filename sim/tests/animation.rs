//! What `[animation]` means.

use std::error::Error;

use whitted::scene::{SceneItem, SceneProblem};
use whitted::{Color, Light, MaterialId, Object, Real, SceneError, Vec3};
use whitted_sim::scene_file::{self, Stage};

const STILL: &str = r#"
[camera]
eye = [0, 1, 8]
look_at = [0, 1, 0]
fovy_deg = 33

[[lights]]
name = "sun"
position = [0, 9, 0]
color = [1, 1, 1]

[materials.red]

[[objects]]
type = "sphere"
name = "ball"
center = [0, 1, 0]
radius = 1
material = "red"
"#;

const MOTION: &str = r#"
[animation]
duration = 2
loop = false

[[animation.tracks]]
target = "camera.orbit"
keys = [[0, 0], [2, [180, 0]]]

[[animation.tracks]]
target = "camera.fovy_deg"
keys = [[0, 20], [2, 40]]

[[animation.tracks]]
target = "objects.ball.center"
interpolation = "smooth"
keys = [[0, [0, 1, 0]], [1, [0, 3, 0]], [2, [0, 1, 0]]]

[[animation.tracks]]
target = "objects.ball.radius"
keys = [[0, 1], [2, 0]]

[[animation.tracks]]
target = "lights.sun.position"
keys = [[0, [0, 9, 0]], [2, [4, 9, 0]]]

[[animation.tracks]]
target = "lights.sun.color"
keys = [[0, [1, 1, 1]], [2, [1, 0, 0.5]]]
"#;

#[test]
fn tracks_move_what_they_name() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("moving.toml", &[STILL, MOTION].concat())?;
    let mut stage = Box::new(Stage::new());
    let frame = file.frame(&mut stage, Real::ONE)?;
    assert_eq!(frame.camera.eye, Vec3::lit("8", "1", "0"));
    assert_eq!(frame.camera.fovy_deg, 30);
    let (ball, red) = (Vec3::lit("0", "3", "0"), MaterialId(0));
    assert_eq!(frame.objects, [Object::sphere(ball, Real::lit("0.5"), red)]);
    let (sun, color) = (Vec3::lit("2", "9", "0"), Color::lit("1", "0.5", "0.75"));
    assert_eq!(frame.lights, [Light::point(sun, color)]);
    // It ends, and stays.
    let frame = file.frame(&mut stage, Real::from(3))?;
    assert_eq!(frame.camera.eye, Vec3::lit("0", "1", "-8"));
    Ok(())
}

#[test]
fn it_loops_unless_told_otherwise() -> Result<(), Box<dyn Error>> {
    let motion = MOTION.replace("loop = false", "");
    let file = scene_file::parse("looping.toml", &[STILL, &motion].concat())?;
    let mut stage = Box::new(Stage::new());
    let frame = file.frame(&mut stage, Real::from(3))?;
    assert_eq!(frame.camera.eye, Vec3::lit("8", "1", "0"));
    Ok(())
}

#[test]
fn without_it_all_is_still() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("still.toml", STILL)?;
    assert!(file.animation.is_none());
    let mut stage = Box::new(Stage::new());
    let frame = file.frame(&mut stage, Real::ONE)?;
    assert_eq!(frame.objects, file.objects);
    assert_eq!(frame.camera, file.settings.camera);
    Ok(())
}

/// The radius vanishes at the end.
#[test]
fn an_impossible_frame_is_led_back_to_its_track() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("moving.toml", &[STILL, MOTION].concat())?;
    let mut stage = Box::new(Stage::new());
    let mut buffer = Box::new(scene_file::Buffer::new());
    let end = Real::from(2);
    let frame = file.frame(&mut stage, end)?;
    let error = buffer.prepare(&frame).err().ok_or("an error")?;
    let said = file.explain_frame(error, end).to_string();
    let expected = "moving.toml:40: animation.tracks[3].keys: at 2.000 s, radius must be from ";
    assert!(said.starts_with(expected), "{said}");

    let still = SceneError {
        item: SceneItem::Camera,
        field: "up",
        problem: SceneProblem::NoDirection,
    };
    let file = scene_file::parse("moving.toml", STILL)?;
    let said = file.explain_frame(still, end).to_string();
    assert!(
        said.starts_with("moving.toml:2: camera.up: at 2.000 s, must not be zero\n"),
        "{said}"
    );
    Ok(())
}
