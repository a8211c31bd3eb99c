//! Output files: names, inputs, links, permissions, and directories of frames.

use std::error::Error;
use std::fs;

use crate::directory::{Directory, Outcome};

const SCENE: &str = "
background = [0.3, 0.6, 0.9]
camera = { eye = [0, 0, 1], look_at = [0, 0, 0], fovy_deg = 33 }
";

/// Returns an empty directory with the scene `scene.toml`.
fn directory(name: &str) -> Result<Directory, Box<dyn Error>> {
    let here = Directory::empty(name)?;
    fs::write(here.0.join("scene.toml"), SCENE)?;
    Ok(here)
}

#[test]
fn names_with_dots_are_kept() -> Outcome {
    let here = directory("dots")?;
    for version in ["ball.v1", "ball.v2"] {
        fs::write(here.0.join(format!("{version}.toml")), SCENE)?;
        here.ok(&["render", &format!("{version}.toml"), "--size", "8x6"])?;
    }
    let pictures = ["ball.v1.png", "ball.v1.toml", "ball.v2.png", "ball.v2.toml"];
    assert_eq!(here.files()?, [&pictures[..], &["scene.toml"]].concat());
    Ok(())
}

#[test]
fn errors_come_before_the_first_ray() -> Outcome {
    let here = directory("early")?;
    // The picture would take hours.
    let large = ["--size", "8192x8192", "--antialias", "16", "-o"];
    for file in ["no/x.png", "x.jpg", "scene.toml"] {
        here.error(&[&["render", "sphereflake"][..], &large, &[file]].concat())?;
        here.error(
            &[
                &["animate", "sphereflake"][..],
                &large,
                &[file, "--fps", "51"],
            ]
            .concat(),
        )?;
    }
    assert_eq!(here.files()?, ["scene.toml"]);
    Ok(())
}

#[cfg(unix)]
#[test]
fn never_overwrites_the_scene() -> Outcome {
    use std::os::unix::fs::symlink;
    let here = directory("itself")?;
    fs::create_dir(here.0.join("sub"))?;
    symlink("scene.toml", here.0.join("link.png"))?;
    symlink("../scene.toml", here.0.join("sub/frame-0001.png"))?;
    fs::hard_link(here.0.join("scene.toml"), here.0.join("hard.gif"))?;
    for (command, output) in [
        ("render", "scene.toml"),
        ("render", "sub/../scene.toml"),
        ("render", "link.png"),
        ("compile", "./scene.toml"),
        ("compile", "hard.gif"),
        ("animate", "hard.gif"),
        ("animate", "sub/"),
    ] {
        let message = here.error(&[command, "scene.toml", "-o", output])?;
        assert!(
            message.contains(": is the scene `scene.toml` itself\n"),
            "{message}"
        );
    }
    // The gallery would write a page with the name of this scene.
    fs::rename(here.0.join("hard.gif"), here.0.join("index.html"))?;
    let message = here.error(&["gallery", "index.html", "-o", ".", "--size", "8x6"])?;
    assert!(message.contains("index.html: is the scene "), "{message}");
    assert_eq!(fs::read_to_string(here.0.join("scene.toml"))?, SCENE);
    let files = ["index.html", "link.png", "scene.toml", "sub"];
    assert_eq!(here.files()?, files);
    Ok(())
}

#[cfg(unix)]
#[test]
fn follows_links_and_keeps_permissions() -> Outcome {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let here = directory("links")?;
    let render = |file| here.ok(&["render", "scene.toml", "--size", "8x6", "-o", file]);
    fs::create_dir(here.0.join("sub"))?;
    fs::write(here.0.join("sub/old.png"), "old")?;
    fs::set_permissions(here.0.join("sub/old.png"), PermissionsExt::from_mode(0o640))?;
    symlink("sub/old.png", here.0.join("one.png"))?;
    symlink("one.png", here.0.join("two.png"))?;
    symlink("sub/new.png", here.0.join("missing.png"))?;
    for file in ["two.png", "missing.png", "plain.png"] {
        render(file)?;
    }
    for link in ["one.png", "two.png", "missing.png"] {
        assert!(here.0.join(link).is_symlink(), "{link}");
    }
    let picture = fs::read(here.0.join("plain.png"))?;
    for file in ["sub/old.png", "sub/new.png"] {
        assert!(fs::read(here.0.join(file))? == picture, "{file}");
    }
    let mode = |file| -> Result<u32, Box<dyn Error>> {
        Ok(fs::metadata(here.0.join(file))?.permissions().mode() & 0o777)
    };
    assert_eq!(mode("sub/old.png")?, 0o640);
    // A new file has the permissions of any new file.
    assert_eq!(mode("plain.png")?, mode("scene.toml")?);
    Ok(())
}

#[test]
fn removes_frames_of_an_earlier_film() -> Outcome {
    let here = directory("stale")?;
    let frames = |count| {
        let animate = ["animate", "scene.toml", "-o", "out/", "--size", "8x6"];
        here.ok(&[&animate[..], &["--frames", count]].concat())
    };
    frames("8")?;
    let out = Directory(here.0.join("out"));
    assert_eq!(out.files()?.len(), 8);
    fs::write(out.0.join("frame-of-a-door.png"), "")?;
    let output = frames("3")?;
    assert!(
        output.starts_with("removed 5 other frames from out/\n"),
        "{output}"
    );
    let names = ["frame-0000.png", "frame-0001.png", "frame-0002.png"];
    assert_eq!(
        out.files()?,
        [&names[..], &["frame-of-a-door.png"]].concat()
    );
    Ok(())
}
