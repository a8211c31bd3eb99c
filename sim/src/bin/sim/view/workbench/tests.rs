use std::path::{Path, PathBuf};
use std::{env, fs, process};

use embedded_graphics::prelude::*;

use super::*;
use crate::args::Passes;
use crate::draw::{Settings, draw_frame};
use crate::open::Scene;
use crate::progress::Progress;
use whitted::real;

const SCENE: &str = include_str!("../../../../../../scenes/whitted.toml");

/// A temporary directory for one test.
struct Directory(PathBuf);

impl Directory {
    fn new(name: &str) -> Outcome<Self> {
        let path = env::temp_dir().join(format!("whitted-{}-{name}", process::id()));
        fs::create_dir_all(&path)?;
        Ok(Self(path))
    }

    fn write(&self, name: &str, text: &str) -> Outcome<PathBuf> {
        let path = self.0.join(name);
        fs::write(&path, text)?;
        Ok(path)
    }
}

impl Drop for Directory {
    fn drop(&mut self) {
        _ = fs::remove_dir_all(&self.0);
    }
}

fn quality() -> Quality {
    Quality {
        size: Size::new(40, 30),
        max_depth: None,
        min_weight: None,
    }
}

fn workbench(scenes: &[PathBuf], display: &str) -> Outcome<Workbench> {
    Workbench::new(&View {
        scenes: scenes.to_vec(),
        display: Some(Display::named(display)?),
        quality: quality(),
    })
}

/// Draws the picture to its end and returns its pixels.
fn drawn(workbench: &mut Workbench) -> Vec<Rgb888> {
    while workbench.draw_step() {}
    let panel = workbench.picture().0;
    let points = panel.bounding_box().points();
    points.map(|point| panel.get_pixel(point)).collect()
}

/// Returns the pixels that `sim render` draws.
fn rendered(path: &Path, display: &str) -> Outcome<Vec<Rgb888>> {
    let scene = Scene::open(path)?;
    let mut buffer = Box::new(Buffer::new());
    pixels(&scene.prepare(&mut buffer)?, display)
}

/// Draws a prepared scene and returns its pixels.
fn pixels(scene: &PreparedScene<'_>, display: &str) -> Outcome<Vec<Rgb888>> {
    let settings = Settings {
        display: Display::named(display)?,
        transfer: None,
        dither: whitted::render::Dither::Ordered,
        passes: Passes::default(),
    };
    let (picture, _) = draw_frame(scene, &settings, &mut Progress::new(0_u32))?;
    let points = picture.bounding_box().points();
    Ok(points.map(|point| picture.get_pixel(point)).collect())
}

fn notice(workbench: &Workbench) -> String {
    match workbench.status().notice {
        Notice::Message(text) | Notice::Error(text) => text.to_owned(),
        Notice::Help => "help".to_owned(),
    }
}

#[test]
fn draws_the_same_as_render_in_both_orders() -> Outcome {
    let here = Directory::new("orders")?;
    let scene = here.write("scene.toml", SCENE)?;
    let expected = rendered(&scene, "st7735")?;
    let mut workbench = workbench(&[scene], "st7735")?;
    assert!(drawn(&mut workbench) == expected);
    workbench.press(Key::Order);
    assert!(drawn(&mut workbench) == expected);
    assert_eq!(workbench.status().percent, 100);
    Ok(())
}

#[test]
fn first_step_covers_the_whole_picture() -> Outcome {
    let here = Directory::new("first")?;
    let mut workbench = workbench(&[here.write("scene.toml", SCENE)?], "ili9341")?;
    assert!(workbench.draw_step());
    assert!(workbench.status().percent < 10);
    let panel = workbench.picture().0;
    assert!(panel.get_pixel(Point::new(300, 20)).b() > 150);
    assert_ne!(panel.get_pixel(Point::new(300, 235)), Rgb888::BLACK);
    Ok(())
}

#[test]
fn keeps_the_picture_while_the_file_has_an_error() -> Outcome {
    let here = Directory::new("broken")?;
    let scene = here.write("scene.toml", SCENE)?;
    let mut workbench = workbench(std::slice::from_ref(&scene), "ssd0323")?;
    let before = drawn(&mut workbench);
    here.write(
        "scene.toml",
        &SCENE.replace("max_depth = 6", "max_depth = 60"),
    )?;
    workbench.reload();
    let line = SCENE.lines().position(|line| line.starts_with("max_depth"));
    let error = format!("scene.toml:{}: max_depth: ", line.ok_or("no line")? + 1);
    assert!(
        notice(&workbench).starts_with(&error),
        "{}",
        notice(&workbench)
    );
    assert!(drawn(&mut workbench) == before);
    // The scene file is invalid now, so keys change the picture of the last valid scene.
    workbench.press(Key::Right);
    assert!(drawn(&mut workbench) != before);
    workbench.press(Key::Reset);
    let fixed = SCENE.replace("max_depth = 6", "max_depth = 0");
    here.write("scene.toml", &fixed)?;
    workbench.reload();
    assert_eq!(notice(&workbench), GREETING);
    assert!(drawn(&mut workbench) == rendered(&scene, "ssd0323")?);
    assert!(drawn(&mut workbench) != before);
    Ok(())
}

#[test]
fn display_stays_black_if_the_file_never_loads() -> Outcome {
    let here = Directory::new("never")?;
    let files = [
        here.write("a.toml", SCENE)?,
        here.write("b.toml", "colour = 1")?,
    ];
    let mut workbench = workbench(&files, "ssd0323")?;
    drawn(&mut workbench);
    workbench.press(Key::NextScene);
    assert!(
        drawn(&mut workbench)
            .iter()
            .all(|color| *color == Rgb888::BLACK)
    );
    assert!(notice(&workbench).starts_with("b.toml:1: colour: "));
    Ok(())
}

#[test]
fn camera_stops_at_its_limits_and_returns() -> Outcome {
    let here = Directory::new("camera")?;
    let mut workbench = workbench(&[here.write("scene.toml", SCENE)?], "ssd0323")?;
    for (key, opposite) in [(Key::Up, Key::Down), (Key::Farther, Key::Closer)] {
        for _ in 0..100 {
            workbench.press(key);
        }
        let limit = drawn(&mut workbench);
        workbench.press(opposite);
        assert!(drawn(&mut workbench) != limit, "{opposite:?}");
    }
    workbench.press(Key::Reset);
    assert_eq!(workbench.viewpoint, Viewpoint::default());
    Ok(())
}

#[test]
fn compiled_scene_orbits_like_its_file() -> Outcome {
    let here = Directory::new("compiled")?;
    let scene = here.write("scene.toml", SCENE)?;
    let compiled = here.0.join("compiled.scene");
    fs::write(&compiled, whitted_sim::scene_file::compile(&scene)?)?;
    let mut workbench = workbench(&[scene, compiled], "ssd0323")?;
    workbench.press(Key::Left);
    let moved = drawn(&mut workbench);
    workbench.press(Key::NextScene);
    let still = drawn(&mut workbench);
    workbench.press(Key::Left);
    assert!(still != moved && drawn(&mut workbench) == moved);
    Ok(())
}

#[test]
fn keys_select_scenes_and_display_options() -> Outcome {
    let here = Directory::new("keys")?;
    let files = [here.write("a.toml", SCENE)?, here.write("b.toml", SCENE)?];
    let mut workbench = workbench(&files, "ssd1306")?;
    let title = |workbench: &Workbench| workbench.status().title();
    assert_eq!(
        title(&workbench),
        "a (1 of 2) on ssd1306 128x64 binary, dither, the scene's transfer, no antialiasing, progressive"
    );
    use Key::{Antialiasing, Display, Dither, Format, NextScene, Order, Transfer};
    for key in [
        NextScene,
        Display,
        Format,
        Order,
        Dither,
        Transfer,
        Antialiasing,
    ] {
        workbench.press(key);
    }
    assert_eq!(
        title(&workbench),
        "b (2 of 2) on ssd0323 128x64 gray2, no dither, linear, 4 rays at edges, line by line"
    );
    workbench.press(Key::PreviousScene);
    assert!(title(&workbench).starts_with("a (1 of 2) "));
    let before = workbench.status().board;
    workbench.press(Key::Chip);
    assert_ne!(workbench.status().board, before);
    workbench.press(Key::Help);
    assert_eq!(notice(&workbench), "help");
    workbench.press(Key::Help);
    assert_eq!(notice(&workbench), GREETING);
    Ok(())
}

#[test]
fn antialiases_after_the_first_drawing() -> Outcome {
    let here = Directory::new("edges")?;
    let mut workbench = workbench(&[here.write("scene.toml", SCENE)?], "ssd0323")?;
    let aliased = drawn(&mut workbench);
    let rays = workbench.status().work.stats.camera;
    workbench.press(Key::Antialiasing);
    let antialiased = drawn(&mut workbench);
    assert!(antialiased != aliased);
    assert!(workbench.status().work.stats.camera > rays);
    assert_eq!(workbench.status().percent, 100);
    for _ in 0..2 {
        workbench.press(Key::Antialiasing);
    }
    assert!(drawn(&mut workbench) == aliased);
    Ok(())
}

#[test]
fn plays_compiled_animations_and_scene_files() -> Outcome {
    let here = Directory::new("plays")?;
    let text = include_str!("../../../../../../tests/scenes/bouncing_ball.toml");
    let file = here.write("ball.toml", text)?;
    let compiled = here.0.join("ball.scene");
    let bytes = Scene::open(&file)?.compile()?;
    fs::write(&compiled, &bytes)?;
    let mut buffer = Box::new(Buffer::new());
    let mut animation = buffer.decode_animation(&bytes)?;
    for path in [file, compiled] {
        let mut workbench = workbench(&[path], "ssd0323")?;
        for milliseconds in [0, 250, 875] {
            workbench.advance(Duration::from_millis(milliseconds));
            let frame = animation.frame(workbench.clock.frame())?;
            let expected = pixels(&frame, "ssd0323")?;
            assert!(drawn(&mut workbench) == expected, "after {milliseconds} ms");
        }
        assert_eq!(workbench.clock.frame(), real!(1.125));
        workbench.press(Key::Pause);
        workbench.advance(Duration::from_secs(1));
        assert_eq!(workbench.clock.frame(), real!(1.125));
    }
    Ok(())
}
