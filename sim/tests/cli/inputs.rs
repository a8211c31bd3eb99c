//! Inputs that are large, damaged or hostile.

use std::fs::{self, File};
use std::io::Write;
use std::process::Stdio;

use whitted::Color;
use whitted_sim::picture::Picture;
use whitted_sim::png16;

use crate::directory::{Directory, Outcome};

/// Start of a PNG of 1,000,000 x 1,000,000 pixels.
const HUGE: [u8; 33] =
    *b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\x00\x0f\x42\x40\x00\x0f\x42\x40\x08\x02\0\0\0\xd3\x0f\xaf\x2a";

#[test]
fn sizes_of_pictures_are_compared_before_their_pixels() -> Outcome {
    let here = Directory::new("sizes")?;
    let picture = |width, height: u32| Picture {
        width,
        height,
        pixels: vec![Color::new(1, 2, 3); (width * height) as usize],
    };
    png16::write(here.0.join("a.png"), &picture(3, 2))?;
    png16::write(here.0.join("b.png"), &picture(2, 3))?;
    // The pixels of this file are missing.
    let truncated = fs::read(here.0.join("b.png"))?;
    fs::write(here.0.join("b.png"), &truncated[..60])?;
    let error = here.error(&["compare", "a.png", "b.png"])?;
    let expected = "error: the sizes differ: 3x2 and 2x3; compare pictures of the same size\n";
    assert_eq!(error, expected);

    fs::write(here.0.join("huge.png"), HUGE)?;
    let error = here.error(&["compare", "huge.png", "huge.png"])?;
    let expected = "error: huge.png: has 1000000x1000000 pixels; at most 67108864 are read\n";
    assert_eq!(error, expected);
    Ok(())
}

#[test]
fn reads_interlaced_pictures() -> Outcome {
    // A picture of 3x2 gray pixels with the samples 0, 40, 80, 120, 160 and 200.
    let interlaced = include_bytes!("inputs/interlaced.png");
    let here = Directory::new("interlaced")?;
    fs::write(here.0.join("a.png"), interlaced)?;
    let picture = png16::read(here.0.join("a.png"))?;
    let grays: Vec<_> = picture.pixels.iter().map(|pixel| pixel.r / 257).collect();
    assert_eq!(grays, [0, 40, 80, 120, 160, 200]);
    Ok(())
}

#[test]
fn refuses_files_above_the_limit() -> Outcome {
    let here = Directory::new("large")?;
    File::create(here.0.join("large.toml"))?.set_len(1 << 30)?;
    File::create(here.0.join("large.scene"))?.set_len(1 << 30)?;
    for name in ["large.toml", "large.scene"] {
        let error = here.error(&["check", name])?;
        let expected = format!("error: {name}: cannot be read: larger than 1 MiB, the limit");
        assert!(error.starts_with(&expected), "{error}");
    }
    Ok(())
}

#[cfg(unix)]
#[test]
fn refuses_endless_devices_and_pipes() -> Outcome {
    let here = Directory::new("endless")?;
    let error = here.error(&["render", "/dev/zero"])?;
    let expected = "error: /dev/zero: cannot be read: larger than 1 MiB, the limit for scenes\n";
    assert_eq!(error, expected);

    let mut command = here.command(&["check", "/dev/stdin"]);
    let mut child = command
        .stdin(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()?;
    let mut pipe = child.stdin.take().ok_or("no pipe")?;
    // The program closes the pipe, and then writing fails.
    while pipe.write_all(&[b'\n'; 4096]).is_ok() {}
    assert_eq!(child.wait()?.code(), Some(2));
    Ok(())
}

#[test]
fn reads_long_scenes_in_linear_time() -> Outcome {
    let here = Directory::new("long")?;
    let material = "[materials.m]\nka = [1, 1, 1]\n";
    let camera = "[camera]\neye = [0, 0, 5]\nlook_at = [0, 0, 0]\nfovy_deg = 33\n";
    let object =
        "[[objects]]\ntype = \"sphere\"\ncenter = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n";
    let comment = "# 3456789\n".repeat(360);
    // 0.9 MB, mostly comments. The former reader counted the lines before each key, which took
    // minutes.
    let scene = [camera, material, &[&comment, object].concat().repeat(250)].concat();
    fs::write(here.0.join("long.toml"), scene)?;
    assert!(
        here.ok(&["check", "long.toml"])?
            .contains("ok, 250 objects")
    );
    Ok(())
}

#[test]
fn file_names_are_escaped() -> Outcome {
    let here = Directory::new("escaped")?;
    let name = "a\u{1b}[2Jb.toml";
    fs::write(here.0.join(name), "x")?;
    let error = here.error(&["check", name])?;
    assert!(error.starts_with(r"error: a\u{1b}[2Jb.toml:1: "), "{error}");
    Ok(())
}
