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
fn too_many_lights_and_objects() {
    let light = "[[lights]]\nposition = [0, 0, 0]\ncolor = [1, 1, 1]\n";
    let expected = "bad.toml:1: lights: must be at most 16, not 17\n  help: remove some of them";
    assert_eq!(message(&light.repeat(17)), expected);
    // The number of objects is reported before the errors in the objects.
    let expected =
        "bad.toml:1: objects: must be at most 256, not 8000\n  help: remove some of them";
    assert_eq!(message(&"[[objects]]\n".repeat(8000)), expected);
}

#[test]
fn long_names_are_shortened() {
    let name = "x".repeat(200_000);
    let short = "x".repeat(60);
    let scene = format!("[materials.{name}]\nkd = 1");
    let start = format!("bad.toml:2: materials.{}…: must be", &short[..50]);
    assert!(message(&scene).starts_with(&start));
    let object = "[[objects]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\n";
    let scene = format!("[materials.{name}]\n{object}material = \"y{name}\"");
    let expected = format!(
        "bad.toml:6: objects[0].material: there is no material `y{}…`
  help: the materials are `{short}…`",
        &short[..59]
    );
    assert_eq!(message(&scene), expected);
}

#[test]
fn control_characters_are_escaped() {
    let expected = r"bad.toml:1: key with no value, expected `=`, found `[31mred\u{1b}]0;title\u{7} = 1`
  help: a scene is written in TOML: `key = value` lines under [table] headings";
    assert_eq!(message("\u{1b}[31mred\u{1b}]0;title\u{7} = 1"), expected);
}
