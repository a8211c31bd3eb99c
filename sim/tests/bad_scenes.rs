//! What is said about bad scene files, word for word.
//!
//! `bad_scenes/*.txt` are lists of cases: a scene file, `---`, the message;
//! `===` between two. A file without a camera gets one at its end; a track's target
//! is none.

use std::error::Error;

use whitted_sim::scene_file::{self, Buffer, LoadError};

const CAMERA: &str = "
[camera]
eye = [0, 2, 8]
look_at = [0, 1, 0]
fovy_deg = 33
";

fn message(scene: &str) -> String {
    let text = match scene.replace("\"camera.", "").contains("camera") {
        true => scene.to_owned(),
        false => format!("{scene}{CAMERA}"),
    };
    match load(&text) {
        Ok(()) => "fine".to_owned(),
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
fn keys() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/keys.txt"))
}

#[test]
fn types() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/types.txt"))
}

/// The keys of each type of object but the simplest.
#[test]
fn shapes() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/shapes.txt"))
}

#[test]
fn numbers() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/numbers.txt"))
}

#[test]
fn syntax() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/syntax.txt"))
}

#[test]
fn camera() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/camera.txt"))
}

#[test]
fn animation() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/animation.txt"))
}

/// Found where the scene is prepared, and led back to its line.
#[test]
fn values() -> Result<(), Box<dyn Error>> {
    check(include_str!("bad_scenes/values.txt"))
}

/// A list without bound would fill the file of cases.
#[test]
fn more_than_there_is_room_for() {
    let light = "[[lights]]\nposition = [0, 0, 0]\ncolor = [1, 1, 1]\n";
    let expected = "bad.toml:1: lights: exceed the buffer's capacity of 16\n  help: leave some out";
    assert_eq!(message(&light.repeat(17)), expected);
}
