//! `sim new`.

use std::fs;

use whitted_sim::png16;

use crate::directory::{Directory, Outcome};

#[test]
fn writes_a_scene_that_renders_well() -> Outcome {
    let here = Directory::new("new")?;
    for name in ["mine.toml", "mine.v1.toml"] {
        _ = fs::remove_file(here.0.join(name));
    }
    let output = here.ok(&["new", "mine"])?;
    let expected = "wrote mine.toml; render it with `cargo sim render mine.toml`\n";
    assert_eq!(output, expected);
    // `ok` also checks that there are no warnings.
    here.ok(&["check", "mine.toml"])?;
    here.ok(&["render", "mine.toml", "--size", "64x48"])?;
    let picture = png16::read(here.0.join("mine.png"))?;
    let luma: f64 = picture
        .pixels
        .iter()
        .map(|p| 0.2126 * f64::from(p.r) + 0.7152 * f64::from(p.g) + 0.0722 * f64::from(p.b))
        .sum();
    let mean = luma / 65535.0 / picture.pixels.len() as f64;
    assert!((0.3..0.6).contains(&mean), "mean luma {mean}");

    // The commented animation is valid, too.
    let text = fs::read_to_string(here.0.join("mine.toml"))?;
    let (scene, animation) = text.split_once("# [animation]").ok_or("no animation")?;
    let animated = format!("{scene}[animation]{}", animation.replace("\n# ", "\n"));
    fs::write(
        here.0.join("animated.toml"),
        animated.replace("\n#\n", "\n"),
    )?;
    here.ok(&["check", "animated.toml"])?;

    here.ok(&["new", "mine.v1"])?;
    assert!(here.0.join("mine.v1.toml").exists());
    Ok(())
}

#[test]
fn does_not_overwrite_a_file() -> Outcome {
    let here = Directory::new("new-taken")?;
    fs::write(here.0.join("taken.toml"), "mine")?;
    let error = here.error(&["new", "taken"])?;
    let expected =
        "error: taken.toml: already exists\n  help: choose another name, or remove the file\n";
    assert_eq!(error, expected);
    assert_eq!(fs::read_to_string(here.0.join("taken.toml"))?, "mine");
    assert!(
        here.error(&["new", "no/such"])?
            .starts_with("error: no/such.toml: cannot be written: ")
    );
    Ok(())
}
