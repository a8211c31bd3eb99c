//! Reads and applies the table `[animation]`.

use std::error::Error;

use whitted::scene::{SceneItem, SceneProblem};
use whitted::{Light, MaterialId, Object, Real, SceneError, color, real, vec3};
use whitted_sim::scene_file::{self, AnimatedScene};

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
keys = [[0, 1], [2, 0.0000152587890625]]

[[animation.tracks]]
target = "lights.sun.position"
keys = [[0, [0, 9, 0]], [2, [4, 9, 0]]]

[[animation.tracks]]
target = "lights.sun.color"
keys = [[0, [1, 1, 1]], [2, [1, 0, 0.5]]]
"#;

#[test]
fn applies_every_kind_of_target() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("moving.toml", &[SCENE, ANIMATION].concat())?;
    let mut buffer = Box::new(AnimatedScene::new());
    let frame = file.frame(&mut buffer, Real::ONE)?;
    assert_eq!(frame.camera.eye, vec3!(8, 1, 0));
    assert_eq!(frame.camera.fovy_deg, 30);
    let (ball, red) = (vec3!(0, 3, 0), MaterialId(0));
    assert_eq!(
        frame.objects,
        [Object::sphere(ball, real!(0.50000762939453125), red)]
    );
    let (sun, color) = (vec3!(2, 9, 0), color!(1, 0.5, 0.75));
    assert_eq!(frame.lights, [Light::point(sun, color)]);
    // After its duration, the animation keeps its last values.
    let frame = file.frame(&mut buffer, Real::from(3))?;
    assert_eq!(frame.camera.eye, vec3!(0, 1, -8));
    Ok(())
}

#[test]
fn loops_by_default() -> Result<(), Box<dyn Error>> {
    let looping = ANIMATION.replace("loop = false", "");
    let file = scene_file::parse("looping.toml", &[SCENE, &looping].concat())?;
    let mut buffer = Box::new(AnimatedScene::new());
    let frame = file.frame(&mut buffer, Real::from(3))?;
    assert_eq!(frame.camera.eye, vec3!(8, 1, 0));
    Ok(())
}

#[test]
fn scene_without_animation_does_not_change() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("still.toml", SCENE)?;
    assert!(file.animation.is_none());
    let mut buffer = Box::new(AnimatedScene::new());
    let frame = file.frame(&mut buffer, Real::ONE)?;
    assert_eq!(frame.objects, file.objects);
    assert_eq!(frame.camera, file.settings.camera);
    Ok(())
}

/// In the last frame, the radius of the ball is too small for the extent of the scene.
#[test]
fn errors_in_a_frame_name_the_track() -> Result<(), Box<dyn Error>> {
    let file = scene_file::parse("moving.toml", &[SCENE, ANIMATION].concat())?;
    let mut animated = Box::new(AnimatedScene::new());
    let mut buffer = Box::new(scene_file::Buffer::new());
    let end = Real::from(2);
    let frame = file.frame(&mut animated, end)?;
    let error = buffer.prepare(&frame).err().ok_or("an error")?;
    let message = file.explain_frame(error, end).to_string();
    let expected = "moving.toml:40: animation.tracks[3].keys[1]: at 2.000 s, radius must be from ";
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
