//! Checks the error messages for invalid scene files, word for word.
//!
//! Each file `bad_scenes/*.txt` is a list of cases, separated by `===`. A case is a scene file,
//! `---`, and the expected message. The test appends a camera to scenes without one, unless
//! the scene only mentions the camera as an animation target.

use std::error::Error;

use whitted_sim::scene_file::{self, Buffer, LoadError};

const CAMERA: &str = "
[camera]
eye = [0, 2, 8]
look_at = [0, 1, 0]
fovy_deg = 33
";

/// Returns the error message for a scene.
fn message(scene: &str) -> String {
    let text = match scene.replace("\"camera.", "").contains("camera") {
        true => scene.to_owned(),
        false => format!("{scene}{CAMERA}"),
    };
    match load(&text) {
        Ok(()) => "no error".to_owned(),
        Err(error) => error.to_string(),
    }
}

fn load(text: &str) -> Result<(), LoadError> {
    let mut buffer = Box::new(Buffer::new());
    scene_file::parse("bad.toml", text)?.prepare(&mut buffer)?;
    Ok(())
}

fn check(cases: &str) -> Result<(), Box<dyn Error>> {
    for case in cases.trim_end().split("\n===\n") {
        let (scene, expected) = case.split_once("\n---\n").ok_or(case)?;
        assert_eq!(message(scene), expected, "{scene}");
    }
    Ok(())
}

#[test]
fn unknown_and_missing_keys() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/keys.txt"))
}

#[test]
fn wrong_types() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/types.txt"))
}

#[test]
fn keys_of_each_type_of_object() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/shapes.txt"))
}

#[test]
fn unrepresentable_numbers() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/numbers.txt"))
}

#[test]
fn syntax_errors() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/syntax.txt"))
}

#[test]
fn camera_errors() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/camera.txt"))
}

#[test]
fn animation_errors() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/animation.txt"))
}

/// The library rejects these values; the simulator finds their lines.
#[test]
fn values_out_of_range() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/values.txt"))
}

/// Generates its scene, which would be too long for a file of cases.
#[test]
fn more_lights_than_the_buffer_holds() {
    let light = "[[lights]]\nposition = [0, 0, 0]\ncolor = [1, 1, 1]\n";
    let expected =
        "bad.toml:1: lights: exceed the buffer's capacity of 16\n  help: remove some of them";
    assert_eq!(message(&light.repeat(17)), expected);
}
