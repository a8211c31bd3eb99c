//! The program: what it writes, says, and exits with.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use whitted::Color;
use whitted_sim::png16;

type Outcome = Result<(), Box<dyn Error>>;

/// A directory of the test's own, to run the program in.
struct Directory(PathBuf);

impl Directory {
    fn new(name: &str) -> Result<Self, Box<dyn Error>> {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        fs::create_dir_all(&path)?;
        Ok(Self(path))
    }

    fn sim(&self, args: &[&str]) -> Result<Output, Box<dyn Error>> {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sim"));
        Ok(command.args(args).current_dir(&self.0).output()?)
    }

    /// What it prints, if it succeeds.
    fn ok(&self, args: &[&str]) -> Result<String, Box<dyn Error>> {
        let output = self.sim(args)?;
        let error = String::from_utf8(output.stderr)?;
        assert_eq!(
            (output.status.code(), error.as_str()),
            (Some(0), ""),
            "{args:?}"
        );
        Ok(String::from_utf8(output.stdout)?)
    }

    /// What it prints as an error, if it exits with 2 and prints nothing else.
    fn error(&self, args: &[&str]) -> Result<String, Box<dyn Error>> {
        let output = self.sim(args)?;
        let said = String::from_utf8(output.stdout)?;
        assert_eq!(
            (output.status.code(), said.as_str()),
            (Some(2), ""),
            "{args:?}"
        );
        Ok(String::from_utf8(output.stderr)?)
    }
}

#[test]
fn alone_it_renders_the_first_scene() -> Outcome {
    let here = Directory::new("alone")?;
    let said = here.ok(&[])?;
    let path = here.0.join("whitted.png");
    // No escapes, as this is no terminal.
    assert_eq!(said, format!("wrote {}\n", path.display()));
    let picture = png16::read(path)?;
    assert_eq!((picture.width, picture.height), (320, 240));
    Ok(())
}

#[test]
fn stats_end_with_the_checksum() -> Outcome {
    let here = Directory::new("stats")?;
    let size = ["--size", "16x12", "--stats"];
    let display = here.ok(&[&["render", "whitted", "-o", "a.png"][..], &size].concat())?;
    let linear = here.ok(&[&["render", "whitted", "--linear16"][..], &size].concat())?;
    assert!(display.contains("\nrays: 192 eye, "), "{display}");
    assert!(display.contains("\nintersection tests: "), "{display}");
    assert!(display.contains("\ntime: "), "{display}");
    for board in ["Cortex-M0+ at 133 MHz", "Cortex-M7 at 480 MHz"] {
        let told = display.lines().find(|line| line.contains(board));
        assert!(
            told.is_some_and(|line| line.contains(" about ")),
            "{display}"
        );
    }
    let [display, linear] = [&display, &linear].map(|said| said.lines().last());
    assert!(display.is_some_and(|line| line.starts_with("checksum: ")));
    assert_eq!(display, linear);
    Ok(())
}

#[test]
fn every_format_is_rendered() -> Outcome {
    let here = Directory::new("formats")?;
    let colors = [
        ("rgb888", 999),
        ("rgb565", 999),
        ("gray8", 256),
        ("gray4", 16),
        ("gray2", 4),
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
fn passes_end_with_the_picture() -> Outcome {
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
fn a_compiled_scene_renders_the_same() -> Outcome {
    let here = Directory::new("compiled")?;
    here.ok(&["compile", "four_spheres", "-o", "four.scene"])?;
    assert!(
        here.ok(&["check", "four.scene"])?
            .starts_with("four.scene: ok")
    );
    let size = ["--size", "40x30", "--linear16"];
    let compiled = here.ok(&[&["render", "four.scene"][..], &size].concat())?;
    assert!(compiled.starts_with(&format!("wrote {}\n", here.0.join("four.png").display())));
    here.ok(&[&["render", "four_spheres"][..], &size].concat())?;
    let said = here.ok(&["compare", "four.png", "four_spheres.png"])?;
    assert_eq!(
        said,
        "PSNR inf, 100% of pixels within 1/255: the pictures are equal\n"
    );
    Ok(())
}

#[test]
fn options_overrule_the_scene() -> Outcome {
    let here = Directory::new("options")?;
    let said = here.ok(&[
        "render",
        "whitted",
        "--size",
        "16x12",
        "--max-depth",
        "0",
        "--stats",
    ])?;
    assert!(
        said.contains("192 eye, 0 reflected, 0 transmitted"),
        "{said}"
    );
    let said = here.ok(&[
        "render",
        "whitted",
        "--size",
        "16x12",
        "--min-weight",
        "1",
        "--stats",
    ])?;
    assert!(said.contains("192 eye, "), "{said}");
    Ok(())
}

#[test]
fn a_scene_is_checked() -> Outcome {
    let here = Directory::new("check")?;
    let said = here.ok(&["check", "scenes/whitted.toml"])?;
    assert!(
        said.starts_with("scenes/whitted.toml: ok, 3 objects, 1 light, 4 materials\n"),
        "{said}"
    );
    Ok(())
}

#[test]
fn a_pixel_is_explained() -> Outcome {
    let here = Directory::new("explain")?;
    let depth = ["--size", "128x96", "--max-depth", "1"];
    let said = here.ok(&[&["explain", "whitted", "60", "48"][..], &depth].concat())?;
    let expected = r#"E object 1, sphere "glass": weight 1.0000, local 0.0000
├─ R object 0, plane "red" or "yellow": weight 0.0800, local (0.6258, 0.4693, 0.0498)
│  └─ S light 0: reached
└─ T object 1, sphere "glass" from inside: weight 0.9300, local 0.0000
   └─ S light 0: filtered by 0.9300
color: (0.0501, 0.0375, 0.0040)
8 bit: (13, 10, 1)
rays: 5: 1 eye, 1 reflected, 1 transmitted, 2 shadow
"#;
    assert_eq!(said, expected);
    here.ok(&["compile", "whitted", "-o", "whitted.scene"])?;
    let said = here.ok(&[&["explain", "whitted.scene", "60", "48"][..], &depth].concat())?;
    // A compiled scene has no names.
    let named = [", plane \"red\" or \"yellow\"", ", sphere \"glass\""];
    let unnamed = named
        .iter()
        .fold(expected.to_owned(), |text, name| text.replace(name, ""));
    assert_eq!(said, unnamed);
    Ok(())
}

#[test]
fn a_gallery_shows_scenes() -> Outcome {
    let here = Directory::new("gallery")?;
    let camera = "camera = { eye = [0, 0, 1], look_at = [0, 0, 0], fovy_deg = 33 }\n";
    let red = format!("title = \"R < G\"\nbackground = [1, 0, 0]\n{camera}");
    let green = format!("background = [0, 1, 0]\n{camera}");
    fs::write(here.0.join("red.toml"), red)?;
    fs::write(here.0.join("green.toml"), green)?;
    let scenes = ["red.toml", "green.toml"];
    let said = here.ok(&[&["gallery", "-o", "out/all", "--size", "8x6"][..], &scenes].concat())?;
    let out = here.0.join("out/all");
    let files = ["red.png", "green.png", "contact-sheet.png", "index.html"];
    let wrote = files.map(|file| format!("wrote {}\n", out.join(file).display()));
    assert_eq!(said, wrote.concat());
    // As `render` draws it.
    here.ok(&["render", "red.toml", "--size", "8x6"])?;
    assert_eq!(
        fs::read(out.join("red.png"))?,
        fs::read(here.0.join("red.png"))?
    );

    let sheet = png16::read(out.join("contact-sheet.png"))?;
    assert_eq!((sheet.width, sheet.height), (2 * 160 + 3 * 8, 120 + 2 * 8));
    let at = |x: usize, y: usize| sheet.pixels[y * sheet.width as usize + x];
    let (red, green) = (Color::new(0xffff, 0, 0), Color::new(0, 0xffff, 0));
    assert_eq!(
        [at(8, 8), at(167, 127), at(176, 8), at(335, 127)],
        [red, red, green, green]
    );
    let between = [
        at(7, 8),
        at(168, 8),
        at(175, 8),
        at(336, 8),
        at(8, 7),
        at(8, 128),
    ];
    assert_eq!(between, [Color::new(0x2020, 0x2020, 0x2020); 6]);

    let page = fs::read_to_string(out.join("index.html"))?;
    assert!(page.contains("<figcaption>R &lt; G\n    <small>8x6, 48 rays, <a href=\"red.png\">"));
    // Without a title, by name.
    assert!(page.contains("<figcaption>green\n"));
    assert!(page.find("red.png") < page.find("green.png"));
    Ok(())
}

#[test]
fn bad_input_is_refused() -> Outcome {
    let here = Directory::new("bad")?;
    fs::write(here.0.join("bad.toml"), "colour = 1\n")?;
    fs::write(here.0.join("bad.scene"), [0xff, 0xfe])?;
    let cases: [(&[&str], &str); 18] = [
        (
            &["render", "bad.toml"],
            "error: bad.toml:1: colour: a scene has no such key\n  help: ",
        ),
        (&["check", "bad.toml"], "error: bad.toml:1: colour: "),
        (
            &["compile", "bad.toml", "-o", "x"],
            "error: bad.toml:1: colour: ",
        ),
        (
            &["check", "bad.scene"],
            "error: bad.scene: not a compiled scene\n  help: ",
        ),
        (
            &["check", "witted"],
            "error: witted: no such scene\n  help: did you mean `scenes/whitted.toml`?\n",
        ),
        (
            &["check", "nothing/like.it"],
            "error: nothing/like.it: no such scene\n  help: scenes/ has ",
        ),
        (&["compare", "a.png", "b.png"], "error: a.png: "),
        (
            &["render", "whitted", "--size", "320"],
            "error: invalid value '320' for '--size <WxH>': write width and",
        ),
        (
            &["render", "whitted", "--size", "0x9"],
            "error: invalid value '0x9' for '--size <WxH>': width and",
        ),
        (
            &["render", "whitted", "--max-depth", "33"],
            "error: invalid value '33' for '--max-depth <N>': 33 is not in 0..=32\n",
        ),
        (
            &["render", "whitted", "--min-weight", "2"],
            "error: --min-weight 2: must be from 0 to 1\n",
        ),
        (
            &["render", "whitted", "--min-weight", "-1"],
            "error: --min-weight -1: must be from 0 to 1\n",
        ),
        (
            &["render", "whitted", "--size", "2x2", "-o", "no/x.png"],
            "error: no/x.png: ",
        ),
        (
            &["explain", "whitted", "320", "0"],
            "error: pixel 320 0: outside of the picture of 320x240\n  help: x is from 0 to 319, y",
        ),
        (
            &["explain", "whitted", "-1", "0"],
            "error: invalid value '-1' for '<X>': ",
        ),
        (
            &["gallery", "-o", "x", "whitted", "scenes/whitted.toml"],
            "error: scenes/whitted.toml: there is another picture `whitted.png`\n  help: ",
        ),
        (
            &["gallery", "-o", "bad.toml/x", "whitted"],
            "error: bad.toml/x: cannot be made: ",
        ),
        (&["rendr"], "error: unrecognized subcommand 'rendr'\n"),
    ];
    for (args, expected) in cases {
        let said = here.error(args)?;
        assert!(said.starts_with(expected), "{args:?}: {said}");
    }
    Ok(())
}

#[cfg(not(feature = "window"))]
#[test]
fn a_window_needs_its_feature() -> Outcome {
    let said = Directory::new("view")?.error(&["view"])?;
    assert!(
        said.contains("libsdl2-dev") && said.contains("--features window"),
        "{said}"
    );
    Ok(())
}
