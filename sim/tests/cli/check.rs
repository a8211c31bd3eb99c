//! `sim check`: animations and warnings.

use std::fs;

use crate::directory::{Directory, Outcome};

const SCENE: &str = r#"[camera]
eye = [0, 0, 5]
look_at = [0, 0, 0]
fovy_deg = 33
[[lights]]
position = [0, 5, 5]
color = [1, 1, 1]
[materials.m]
kd = [1, 1, 1]
[[objects]]
type = "sphere"
name = "ball"
center = [0, 0, 0]
radius = 1
material = "m"
"#;

/// Runs `sim check` on a scene and returns its exit code and its messages.
fn check(name: &str, scene: &str) -> Result<(Option<i32>, String), Box<dyn std::error::Error>> {
    let here = Directory::new(&format!("check-{name}"))?;
    fs::write(here.0.join("a.toml"), scene)?;
    let output = here.command(&["check", "a.toml"]).output()?;
    Ok((output.status.code(), String::from_utf8(output.stderr)?))
}

#[test]
fn checks_values_between_keyframes() -> Outcome {
    // The spline through these keyframes falls below 0 between 1 s and 2 s.
    let track = "[animation]\nduration = 3\n[[animation.tracks]]\ninterpolation = \"smooth\"\n";
    let keys = "target = \"objects.ball.radius\"\nkeys = [\n[0, 9],\n[1, 0.1],\n[2, 0.1],\n[3, 9]]";
    let (code, message) = check("spline", &[SCENE, track, keys].concat())?;
    assert_eq!(code, Some(2));
    assert!(
        message.starts_with("error: a.toml:23: animation.tracks[0].keys[1]: "),
        "{message}"
    );
    assert!(message.contains("radius must be from "), "{message}");
    Ok(())
}

#[test]
fn warns_about_odd_scenes() -> Outcome {
    let replaced = |from: &str, to: &str| SCENE.replace(from, to);
    let light = "[[lights]]\nposition = [0, 5, 5]\ncolor = [1, 1, 1]\n";
    let floor =
        "[[objects]]\ntype = \"plane\"\nnormal = [0, -1, 0]\npoint = [0, 4, 0]\nmaterial = \"m\"\n";
    let cases = [
        (
            replaced(light, ""),
            "a.toml: lights: the scene has no lights, so",
        ),
        (
            replaced("[0, 5, 5]", "[0, 0.5, 0]"),
            "a.toml:6: lights[0].position: is inside the opaque",
        ),
        (
            replaced("[0, 0, 5]", "[0, 0, 0.5]"),
            "a.toml:2: camera.eye: is inside the opaque object 0",
        ),
        (
            replaced("look_at = [0, 0, 0]", "look_at = [0, 0, 9]"),
            "a.toml:1: camera: sees no object",
        ),
        (
            replaced("color = [1, 1, 1]", "color = [0, 0, 0]"),
            "a.toml:7: lights[0].color: is black",
        ),
        (
            replaced("kd = [1, 1, 1]", ""),
            "a.toml:8: materials.m: is black in any light",
        ),
        (
            format!("{SCENE}[materials.spare]\nkd = [1, 1, 1]\n"),
            "a.toml:16: materials.spare: is used by no object",
        ),
        (
            replaced("kd =", "kr = [1, 1, 1]\nkd =").replace("[camera]", "max_depth = 0\n[camera]"),
            "a.toml:10: materials.m.kr: has no effect, because `max_depth` is 0",
        ),
        (
            replaced("kd =", "kt = [1, 1, 1]\nior = 1.5\nkd =")
                .replace("[camera]", "max_depth = 1\n[camera]"),
            "a.toml:10: materials.m.kt: needs rays that enter and leave",
        ),
        (
            [SCENE, floor].concat(),
            "a.toml:6: lights[0].position: is inside the opaque object 1",
        ),
        (
            SCENE
                .split("[[objects]]")
                .next()
                .unwrap_or_default()
                .to_owned(),
            "a.toml: objects: the scene has no objects",
        ),
    ];
    for (number, (scene, expected)) in cases.iter().enumerate() {
        let (code, message) = check(&format!("warns-{number}"), scene)?;
        assert_eq!(code, Some(0), "{message}");
        let warnings: Vec<_> = message.split_inclusive("warning: ").collect();
        let expected = warnings
            .iter()
            .filter(|warning| warning.starts_with(expected))
            .count();
        assert_eq!(expected, 1, "{scene}\n{message}");
    }
    Ok(())
}

#[test]
fn does_not_warn_about_ordinary_scenes() -> Outcome {
    // A room with an opaque sphere as its walls, and glass around a light.
    let room =
        "[[objects]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 50\nmaterial = \"m\"\n";
    let (code, message) = check("room", &[SCENE, room].concat())?;
    assert_eq!((code, message.as_str()), (Some(0), ""));
    // The light leaves the ball.
    let track = "[animation]\nduration = 1\n[[animation.tracks]]\ntarget = \"lights.sun.position\"\nkeys = [[0, [0, 0, 0]], [1, [0, 5, 0]]]";
    let light = "[[lights]]\nname = \"sun\"\nposition = [0, 0, 0]\ncolor = [1, 1, 1]\n";
    let (code, message) = check("moving", &[SCENE, light, track].concat())?;
    assert_eq!((code, message.as_str()), (Some(0), ""));
    Ok(())
}
