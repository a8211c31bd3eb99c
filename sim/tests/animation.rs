//! Reads and applies the table `[animation]`.

#![allow(clippy::unwrap_used)]

use std::error::Error;

use embedded_graphics_core::geometry::Size;
use whitted::scene::{SceneItem, SceneProblem};
use whitted::{Light, MaterialId, Object, Real, Scene, SceneError, color, real, vec3};
use whitted_sim::scene_file::{self, Buffer, SceneFile};
use whitted_sim::{compare, render};

const SCENE: &str = r#"
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

const ANIMATION: &str = r#"
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
keys = [[0, 1], [2, 0.1]]

[[animation.tracks]]
target = "lights.sun.position"
keys = [[0, [0, 9, 0]], [2, [4, 9, 0]]]

[[animation.tracks]]
target = "lights.sun.color"
keys = [[0, [1, 1, 1]], [2, [1, 0, 0.5]]]
"#;

/// Compares a frame of a scene file with a scene. Both must have equal pictures, except for the last
/// bits, because their scales may differ.
#[track_caller]
fn assert_frame(file: &SceneFile, time: Real, expected: &Scene<'_>) {
    let bytes = file.compile().unwrap();
    let mut buffer = Box::new(Buffer::new());
    let mut animation = buffer.decode_animation(&bytes).unwrap();
    let frame = animation.frame(time).unwrap();
    assert_eq!(frame.camera(), expected.camera);
    let frame = render::linear(&frame, Size::new(64, 48));
    let expected = buffer
        .prepare(expected)
        .map(|scene| render::linear(&scene, Size::new(64, 48)));
    let comparison = compare::compare(&frame, &expected.unwrap()).unwrap();
    assert!(comparison.psnr > 90.0, "{} dB", comparison.psnr);
}

#[test]
fn applies_every_kind_of_target() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("moving.toml", &[SCENE, ANIMATION].concat())?;
    let mut camera = file.settings.camera;
    camera.eye = vec3!(8, 1, 0);
    camera.fovy_deg = real!(30);
    let (sun, color) = (vec3!(2, 9, 0), color!(1, 0.5, 0.75));
    let (ball, red) = (vec3!(0, 3, 0), MaterialId(0));
    let expected = Scene {
        camera,
        objects: &[Object::sphere(ball, real!(0.55), red)],
        lights: &[Light::point(sun, color)],
        ..file.scene()
    };
    assert_frame(&file, Real::ONE, &expected);
    // After its duration, the animation keeps its last values.
    camera.eye = vec3!(0, 1, -8);
    camera.fovy_deg = real!(40);
    let expected = Scene {
        camera,
        objects: &[Object::sphere(vec3!(0, 1, 0), real!(0.1), red)],
        lights: &[Light::point(vec3!(4, 9, 0), color!(1, 0, 0.5))],
        ..expected
    };
    assert_frame(&file, Real::from(3), &expected);
    Ok(())
}

#[test]
fn loops_by_default() -> Result<(), Box<dyn Error>> {
    let looping = ANIMATION.replace("loop = false", "");
    let file = scene_file::parse("looping.toml", &[SCENE, &looping].concat())?;
    let bytes = file.compile()?;
    let mut buffer = Box::new(Buffer::new());
    let mut animation = buffer.decode_animation(&bytes)?;
    let frame = animation.frame(Real::from(3))?;
    assert_eq!(frame.camera().eye, vec3!(8, 1, 0));
    Ok(())
}

#[test]
fn scene_without_animation_does_not_change() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("still.toml", SCENE)?;
    assert!(file.animation.is_none());
    assert_frame(&file, Real::ONE, &file.scene());
    Ok(())
}

#[test]
fn errors_in_values_name_the_keyframe() -> Result<(), Box<dyn Error>> {
    let shrinking = ANIMATION.replace("[2, 0.1]", "[2, 0.0000152587890625]");
    let file = scene_file::parse("moving.toml", &[SCENE, &shrinking].concat())?;
    let message = file.compile().err().ok_or("an error")?.to_string();
    let expected = "moving.toml:40: animation.tracks[3].keys[1]: radius must be from ";
    assert!(message.starts_with(expected), "{message}");
    Ok(())
}

#[test]
fn errors_in_a_frame_name_the_track() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("moving.toml", &[SCENE, ANIMATION].concat())?;
    let end = Real::from(2);
    let error = SceneError {
        item: SceneItem::Camera,
        field: "look_at",
        problem: SceneProblem::NoView,
    };
    let message = file.explain_frame(error, end).to_string();
    let expected = "moving.toml:27: animation.tracks[0].keys[1]: at 2.000 s, look_at must differ";
    assert!(message.starts_with(expected), "{message}");

    let error = SceneError {
        item: SceneItem::Camera,
        field: "up",
        problem: SceneProblem::NoDirection,
    };
    let file = scene_file::parse("moving.toml", SCENE)?;
    let message = file.explain_frame(error, end).to_string();
    assert!(
        message.starts_with("moving.toml:2: camera.up: at 2.000 s, must not be zero\n"),
        "{message}"
    );
    Ok(())
}
