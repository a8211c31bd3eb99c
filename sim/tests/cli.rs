//! The program: what it writes, says, and exits with.

use std::error::Error;
use std::fs::{self, File};
use std::io::BufReader;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use embedded_graphics_core::geometry::Size;
use whitted::Color;
use whitted_sim::cost::{BOARDS, Work};
use whitted_sim::{png16, scene_file};

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
        Ok(self.command(args).output()?)
    }

    fn command(&self, args: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sim"));
        command.args(args).current_dir(&self.0);
        command
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

/// What is decoded and each line included, of a scene where that counts.
#[test]
fn stats_tell_what_the_model_predicts() -> Outcome {
    let here = Directory::new("estimate")?;
    let said = here.ok(&["render", "phong_terms", "--size", "96x72", "--stats"])?;
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/phong_terms.toml");
    let mut buffer = Box::new(scene_file::Buffer::new());
    let file = scene_file::load(&file)?;
    let work = Work::of(&file.prepare(&mut buffer)?, Size::new(96, 72));
    for board in &BOARDS[..2] {
        let title = format!("{} at", board.title);
        let predicted = board.instructions(&work) / 1e6;
        let told = format!(" {predicted:.1} M instructions");
        let line = said.lines().find(|line| line.contains(&title));
        assert!(
            line.is_some_and(|line| line.ends_with(&told)),
            "{told}, but {said}"
        );
    }
    Ok(())
}

#[test]
fn every_format_is_rendered() -> Outcome {
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
fn blocks_are_dithered_pixel_by_pixel() -> Outcome {
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
fn displays_are_listed_and_drawn_on() -> Outcome {
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
fn a_display_has_its_own_colors_and_scale() -> Outcome {
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
fn dither_transfer_and_smooth_edges_change_the_picture() -> Outcome {
    let here = Directory::new("output")?;
    let plain = ["render", "whitted", "--size", "40x30", "--format", "gray4"];
    let mut pictures = Vec::new();
    for options in [
        &[][..],
        &["--dither", "off"],
        &["--transfer", "srgb"],
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
    here.ok(&[&linear[..], &["--antialias", "4", "-o", "smooth.png"]].concat())?;
    let [plain, smooth] = ["plain.png", "smooth.png"].map(|file| png16::read(here.0.join(file)));
    assert!(plain? != smooth?);
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
color: (0.0501, 0.0375, 0.0040)
8 bit: (13, 10, 1)
rays: 4: 1 eye, 1 reflected, 1 transmitted, 1 shadow
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

/// The frames of an animation, red, green and blue, and how long each is shown.
type Frames = (Vec<Vec<u8>>, Vec<u16>);

/// The frames of an APNG, each drawn over those before.
fn apng_frames(path: &Path) -> Result<Frames, Box<dyn Error>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path)?)).read_info()?;
    let control = reader.info().animation_control.ok_or("is not animated")?;
    assert_eq!(control.num_plays, 0);
    let [width, height] = [reader.info().width, reader.info().height].map(|side| side as usize);
    let mut picture = vec![0; 3 * width * height];
    let (mut frames, mut delays) = (Vec::new(), Vec::new());
    for _ in 0..control.num_frames {
        let mut part = vec![0; reader.output_buffer_size().ok_or("too large")?];
        reader.next_frame(&mut part)?;
        let control = reader.info().frame_control.ok_or("a frame")?;
        let (left, top) = (control.x_offset as usize, control.y_offset as usize);
        let length = 3 * control.width as usize;
        for (y, row) in (top..)
            .zip(part.chunks_exact(length))
            .take(control.height as usize)
        {
            let at = 3 * (y * width + left);
            picture[at..at + length].copy_from_slice(row);
        }
        frames.push(picture.clone());
        delays.push(control.delay_num);
    }
    Ok((frames, delays))
}

/// The frames of a GIF, each drawn over those before.
fn gif_frames(path: &Path) -> Result<Frames, Box<dyn Error>> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut reader = options.read_info(File::open(path)?)?;
    let width = usize::from(reader.width());
    let mut picture = vec![0; 3 * width * usize::from(reader.height())];
    let (mut frames, mut delays) = (Vec::new(), Vec::new());
    while let Some(frame) = reader.read_next_frame()? {
        let (left, top) = (usize::from(frame.left), usize::from(frame.top));
        for (y, row) in (top..).zip(frame.buffer.chunks_exact(4 * usize::from(frame.width))) {
            for (x, rgba) in (left..).zip(row.as_chunks::<4>().0) {
                if let [rgb @ .., 255] = rgba {
                    picture[3 * (y * width + x)..][..3].copy_from_slice(rgb);
                }
            }
        }
        frames.push(picture.clone());
        delays.push(frame.delay);
    }
    assert_eq!(reader.repeat(), gif::Repeat::Infinite);
    Ok((frames, delays))
}

/// As a GIF, as an APNG and as PNGs they are the same pictures; 16 grays are
/// few enough for a GIF to show them as they are.
#[test]
fn a_scene_is_animated() -> Outcome {
    let here = Directory::new("animate")?;
    let scene = [
        "animate",
        "bouncing_ball",
        "--size",
        "40x30",
        "--frames",
        "4",
    ];
    let gray = [&scene[..], &["--format", "gray4", "-o"]].concat();
    let said = here.ok(&[&gray[..], &["out"]].concat())?;
    assert_eq!(said, format!("wrote {}\n", here.0.join("out").display()));
    here.ok(&[&gray[..], &["ball.gif"]].concat())?;
    here.ok(&[&gray[..], &["ball.apng"]].concat())?;
    let mut frames = Vec::new();
    for index in 0..4 {
        let picture = png16::read(here.0.join(format!("out/frame-000{index}.png")))?;
        let samples = picture.pixels.iter().flat_map(|c| [c.r, c.g, c.b]);
        frames.push(
            samples
                .map(|sample| (sample / 257) as u8)
                .collect::<Vec<_>>(),
        );
    }
    frames.windows(2).for_each(|two| assert!(two[0] != two[1]));
    let of_gif = gif_frames(&here.0.join("ball.gif"))?;
    let of_apng = apng_frames(&here.0.join("ball.apng"))?;
    assert!(of_gif.0 == frames && of_apng.0 == frames);
    // Of two seconds.
    assert_eq!((of_gif.1, of_apng.1), (vec![50; 4], vec![500; 4]));

    // The first frame is the still scene.
    let still = [
        "render",
        "bouncing_ball",
        "--size",
        "40x30",
        "--format",
        "gray4",
    ];
    here.ok(&still)?;
    let said = here.ok(&["compare", "bouncing_ball.png", "out/frame-0000.png"])?;
    assert!(said.ends_with("the pictures are equal\n"), "{said}");
    Ok(())
}

/// A ball that moves a little before a background that does not.
const BALL: &str = r#"
[camera]
eye = [0, 0, 8]
look_at = [0, 0, 0]
fovy_deg = 33
[materials.white]
le = [1, 1, 1]
[[objects]]
type = "sphere"
name = "ball"
center = [0, 0, 0]
radius = 0.5
material = "white"
[animation]
duration = 1
[[animation.tracks]]
target = "objects.ball.center"
keys = [[0, [0, 0, 0]], [1, [1, -0.5, 0]]]
"#;

#[test]
fn of_a_frame_only_what_changed_is_written() -> Outcome {
    let here = Directory::new("change")?;
    fs::write(here.0.join("ball.toml"), BALL)?;
    let scene = [
        "animate",
        "ball.toml",
        "--size",
        "40x30",
        "--frames",
        "3",
        "-o",
    ];
    here.ok(&[&scene[..], &["ball.gif"]].concat())?;
    here.ok(&[&scene[..], &["ball.apng"]].concat())?;
    here.ok(&[&scene[..], &["out"]].concat())?;
    let (of_gif, _) = gif_frames(&here.0.join("ball.gif"))?;
    let (of_apng, _) = apng_frames(&here.0.join("ball.apng"))?;
    for (index, (of_gif, of_apng)) in of_gif.iter().zip(&of_apng).enumerate() {
        let picture = png16::read(here.0.join(format!("out/frame-000{index}.png")))?;
        let samples = picture.pixels.iter().flat_map(|c| [c.r, c.g, c.b]);
        let samples: Vec<_> = samples.map(|sample| (sample / 257) as u8).collect();
        assert!(*of_gif == samples && *of_apng == samples, "frame {index}");
    }
    let mut reader = gif::DecodeOptions::new().read_info(File::open(here.0.join("ball.gif"))?)?;
    let mut sizes = Vec::new();
    while let Some(frame) = reader.next_frame_info()? {
        sizes.push((frame.width, frame.height));
    }
    assert_eq!(sizes[0], (40, 30));
    assert!(
        sizes[1..]
            .iter()
            .all(|(width, height)| *width < 16 && *height < 12),
        "{sizes:?}"
    );
    Ok(())
}

#[test]
fn many_colors_fit_a_gif() -> Outcome {
    let here = Directory::new("colors")?;
    let scene = [
        "animate",
        "bouncing_ball",
        "--size",
        "64x48",
        "--frames",
        "3",
        "-o",
    ];
    here.ok(&[&scene[..], &["ball.gif"]].concat())?;
    here.ok(&[&scene[..], &["ball.png"]].concat())?;
    let (few, _) = gif_frames(&here.0.join("ball.gif"))?;
    let (all, _) = apng_frames(&here.0.join("ball.png"))?;
    for (few, all) in few.iter().zip(&all) {
        let off = few.iter().zip(all).map(|(a, b)| u32::from(a.abs_diff(*b)));
        let mean = f64::from(off.sum::<u32>()) / few.len() as f64;
        assert!(mean < 3.0, "off by {mean} of 255");
    }
    Ok(())
}

#[test]
fn a_still_scene_is_orbited_once() -> Outcome {
    let here = Directory::new("orbit")?;
    let said = here.ok(&[
        "animate", "whitted", "--size", "16x12", "--frames", "4", "-o", "w.gif",
    ])?;
    let note = "the scene has no [animation]: its camera orbits once\n";
    assert!(said.starts_with(note), "{said}");
    let (frames, delays) = gif_frames(&here.0.join("w.gif"))?;
    assert_eq!((frames.len(), delays), (4, vec![100; 4]));
    Ok(())
}

#[test]
fn a_frame_that_cannot_be_is_named() -> Outcome {
    let here = Directory::new("vanishing")?;
    let scene = r#"
[camera]
eye = [0, 1, 8]
look_at = [0, 1, 0]
fovy_deg = 33
[animation]
duration = 1
[[animation.tracks]]
target = "camera.fovy_deg"
keys = [[0, 33], [1, 0]]
"#;
    fs::write(here.0.join("vanishing.toml"), scene)?;
    let args = [
        "animate",
        "vanishing.toml",
        "--size",
        "2x2",
        "--frames",
        "2",
        "-o",
        "x.gif",
    ];
    // A loop never gets to its end.
    here.ok(&args)?;
    let once = scene.replace("duration = 1", "duration = 1\nloop = false");
    fs::write(here.0.join("vanishing.toml"), once)?;
    let said = here.error(&args)?;
    let expected = "error: vanishing.toml:11: animation.tracks[0].keys: at 1.000 s, fovy_deg must be from 1 to";
    assert!(said.starts_with(expected), "{said}");
    Ok(())
}

#[test]
fn bad_input_is_refused() -> Outcome {
    let here = Directory::new("bad")?;
    fs::write(here.0.join("bad.toml"), "colour = 1\n")?;
    fs::write(here.0.join("bad.scene"), [0xff, 0xfe])?;
    let cases: [(&[&str], &str); 25] = [
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
            &["render", "whitted", "--display", "ssd1360"],
            "error: invalid value 'ssd1360' for '--display <NAME>': did you mean `ssd1306`?",
        ),
        (
            &["render", "whitted", "--display", "ssd1306", "--size", "9x9"],
            "error: the argument '--display <NAME>' cannot be used with '--size <WxH>'",
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
        (
            &["animate", "whitted", "-o", "x.mp4"],
            "error: x.mp4: no known kind of animation\n  help: write FILE.gif, FILE.apng, or DIR/",
        ),
        (
            &["animate", "whitted", "-o", "no/x.gif"],
            "error: no/x.gif: cannot be written: ",
        ),
        (
            &["animate", "whitted", "-o", "x.gif", "--fps", "0"],
            "error: invalid value '0' for '--fps <N>': 0 is not in 1..=100\n",
        ),
        (
            &["animate", "bad.scene", "-o", "x.gif"],
            "error: bad.scene: a compiled scene does not move\n  help: ",
        ),
        (
            &["animate", "whitted", "-o", "x.gif", "--frames", "20000"],
            "error: the animation would be 20000 frames, of at most 10000\n  help: ",
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
    let here = Directory::new("view")?;
    // Cargo would be asked for it.
    let output = here.command(&["view"]).env_remove("CARGO").output()?;
    assert_eq!(output.status.code(), Some(2));
    let said = String::from_utf8(output.stderr)?;
    assert!(
        said.contains("libsdl2-dev") && said.contains("--features window"),
        "{said}"
    );
    Ok(())
}
