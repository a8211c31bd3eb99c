//! `sim render` and `sim displays`.

use std::error::Error;
use std::fs;

use whitted_sim::png16;

use crate::directory::{Directory, Outcome};

#[test]
fn without_a_command_renders_the_first_scene() -> Outcome {
    let here = Directory::new("alone")?;
    let output = here.ok(&[])?;
    let path = here.0.join("whitted.png");
    // No escape sequences, since stdout is no terminal.
    assert_eq!(output, format!("wrote {}\n", path.display()));
    let picture = png16::read(path)?;
    assert_eq!((picture.width, picture.height), (320, 240));
    Ok(())
}

#[test]
fn renders_every_format() -> Outcome {
    let here = Directory::new("formats")?;
    let colors = [
        ("rgb888", 999),
        ("rgb666", 999),
        ("rgb565", 999),
        ("rgb555", 999),
        ("gray8", 256),
        ("gray4", 16),
        ("gray2", 4),
        ("binary", 2),
        ("bw", 2),
    ];
    for (format, most) in colors {
        let file = format!("{format}.png");
        here.ok(&[
            "render", "whitted", "--size", "40x30", "--format", format, "-o", &file,
        ])?;
        let mut pixels = png16::read(here.0.join(file))?.pixels;
        pixels.sort_by_key(|pixel| (pixel.r, pixel.g, pixel.b));
        pixels.dedup();
        assert!(
            (2..=most).contains(&pixels.len()),
            "{format}: {} colors",
            pixels.len()
        );
    }
    Ok(())
}

#[test]
fn progressive_passes_refine_blocks() -> Outcome {
    let here = Directory::new("passes")?;
    let render = |order: &[&str]| {
        let args = ["render", "whitted", "--size", "70x33", "-o", "passes.png"];
        here.ok(&[&args, order].concat())?;
        Ok::<_, Box<dyn Error>>(png16::read(here.0.join("passes.png"))?.pixels)
    };
    let scanlines = render(&["--passes", "1"])?;
    for passes in 1..=5_u8 {
        let count = passes.to_string();
        let pixels = render(&["--order", "progressive", "--passes", &count])?;
        assert_eq!(pixels == scanlines, passes == 5, "{passes}");
        let block = 16 >> (passes - 1);
        for (index, pixel) in pixels.iter().enumerate() {
            let (x, y) = (index % 70, index / 70);
            let corner = y / block * block * 70 + x / block * block;
            assert_eq!(*pixel, scanlines[corner], "({x}, {y}), blocks of {block}");
        }
    }
    Ok(())
}

#[test]
fn dithers_each_pixel_of_a_block() -> Outcome {
    let here = Directory::new("blocks")?;
    let camera = "camera = { eye = [0, 0, 1], look_at = [0, 0, 0], fovy_deg = 33 }\n";
    fs::write(
        here.0.join("gray.toml"),
        format!("background = [0.3, 0.3, 0.3]\n{camera}"),
    )?;
    let render = |passes: &str| {
        let order = ["--order", "progressive", "--passes", passes];
        let args = [
            "render",
            "gray.toml",
            "--size",
            "40x30",
            "--format",
            "gray4",
        ];
        here.ok(&[&args[..], &order].concat())?;
        Ok::<_, Box<dyn Error>>(png16::read(here.0.join("gray.png"))?.pixels)
    };
    let dithered = render("5")?;
    assert!(dithered.iter().any(|pixel| *pixel != dithered[0]));
    assert!(render("1")? == dithered);
    Ok(())
}

#[test]
fn lists_and_simulates_displays() -> Outcome {
    let here = Directory::new("displays")?;
    let list = here.ok(&["displays"])?;
    assert_eq!(list.lines().count(), 7, "{list}");
    for line in list.lines() {
        let [name, size] = [0, 1].map(|column| line.split_whitespace().nth(column));
        let (name, size) = (name.ok_or(line)?, size.ok_or(line)?);
        here.ok(&["render", "whitted", "--display", name, "-o", "display.png"])?;
        let picture = png16::read(here.0.join("display.png"))?;
        assert_eq!(format!("{}x{}", picture.width, picture.height), size);
    }
    Ok(())
}

#[test]
fn display_sets_colors_and_scale() -> Outcome {
    let here = Directory::new("display")?;
    let args = ["render", "whitted", "--display", "ssd1306", "--scale", "2"];
    here.ok(&args)?;
    let picture = png16::read(here.0.join("whitted.png"))?;
    assert_eq!((picture.width, picture.height), (256, 128));
    let color = |rgb: [u16; 3]| rgb.map(|channel| 257 * channel);
    let blues = [[0, 20, 40], [0, 210, 255]].map(color);
    let mut pixels = picture
        .pixels
        .iter()
        .map(|pixel| [pixel.r, pixel.g, pixel.b]);
    assert!(pixels.all(|pixel| blues.contains(&pixel)));
    Ok(())
}

#[test]
fn dither_transfer_and_antialiasing_change_the_picture() -> Outcome {
    let here = Directory::new("output")?;
    let plain = ["render", "whitted", "--size", "40x30", "--format", "gray4"];
    let mut pictures = Vec::new();
    for options in [
        &[][..],
        &["--dither", "off"],
        &["--transfer", "linear"],
        &["--antialias", "4"],
        &["--antialias", "16"],
    ] {
        here.ok(&[&plain[..], &["-o", "shown.png"], options].concat())?;
        pictures.push(png16::read(here.0.join("shown.png"))?);
    }
    for (index, picture) in pictures.iter().enumerate() {
        assert!(!pictures[..index].contains(picture), "the picture {index}");
    }
    let linear = ["render", "whitted", "--size", "40x30", "--linear16"];
    here.ok(&[&linear[..], &["-o", "plain.png"]].concat())?;
    here.ok(&[&linear[..], &["--antialias", "4", "-o", "antialiased.png"]].concat())?;
    let [plain, antialiased] =
        ["plain.png", "antialiased.png"].map(|file| png16::read(here.0.join(file)));
    assert!(plain? != antialiased?);
    Ok(())
}
