use std::path::{Path, PathBuf};
use std::{env, fs, process};

use embedded_graphics::prelude::*;

use super::*;
use crate::args::{Passes, Shown};
use crate::draw::draw;
use crate::open::Scene;

const SCENE: &str = include_str!("../../../../../../scenes/whitted.toml");

/// Files of a test's own.
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

/// All pixels, once there is nothing left to draw.
fn drawn(workbench: &mut Workbench) -> Vec<Rgb888> {
    while workbench.tick() {}
    let panel = workbench.picture().0;
    let points = panel.bounding_box().points();
    points.map(|point| panel.get_pixel(point)).collect()
}

/// What `sim render` makes of it.
fn rendered(path: &Path, display: &str) -> Outcome<Vec<Rgb888>> {
    let scene = Scene::open(path)?;
    let mut buffer = Box::new(Buffer::new());
    let prepared = scene.prepare(&mut buffer)?;
    let display = Display::named(display)?;
    let mut shown = Shown::default();
    shown.format = display.format;
    let image = draw(&prepared, display.size, shown, Passes::default())?.image;
    let image = image.as_image_buffer();
    Ok(image
        .pixels()
        .map(|pixel| Rgb888::new(pixel.0[0], pixel.0[1], pixel.0[2]))
        .collect())
}

fn notice(workbench: &Workbench) -> String {
    match workbench.status().notice {
        Notice::Message(text) | Notice::Error(text) => text.to_owned(),
        Notice::Help => "help".to_owned(),
    }
}

#[test]
fn it_draws_what_render_draws_in_either_order() -> Outcome {
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
fn the_first_step_shows_something_everywhere() -> Outcome {
    let here = Directory::new("first")?;
    let mut workbench = workbench(&[here.write("scene.toml", SCENE)?], "ili9341")?;
    assert!(workbench.tick());
    assert!(workbench.status().percent < 10);
    let panel = workbench.picture().0;
    assert!(panel.get_pixel(Point::new(300, 20)).b() > 150);
    assert_ne!(panel.get_pixel(Point::new(300, 235)), Rgb888::BLACK);
    Ok(())
}

#[test]
fn a_broken_file_keeps_the_picture_until_it_is_mended() -> Outcome {
    let here = Directory::new("broken")?;
    let scene = here.write("scene.toml", SCENE)?;
    let mut workbench = workbench(std::slice::from_ref(&scene), "ssd0323")?;
    let before = drawn(&mut workbench);
    here.write(
        "scene.toml",
        &SCENE.replace("max_depth = 6", "max_depth = 60"),
    )?;
    workbench.read();
    let line = SCENE.lines().position(|line| line.starts_with("max_depth"));
    let told = format!("scene.toml:{}: max_depth: ", line.ok_or("no line")? + 1);
    assert!(
        notice(&workbench).starts_with(&told),
        "{}",
        notice(&workbench)
    );
    assert!(drawn(&mut workbench) == before);
    // Keys go on working, with what was read last.
    workbench.press(Key::Right);
    assert!(drawn(&mut workbench) != before);
    workbench.press(Key::Reset);
    let mended = SCENE.replace("max_depth = 6", "max_depth = 0");
    here.write("scene.toml", &mended)?;
    workbench.read();
    assert_eq!(notice(&workbench), GREETING);
    assert!(drawn(&mut workbench) == rendered(&scene, "ssd0323")?);
    assert!(drawn(&mut workbench) != before);
    Ok(())
}

#[test]
fn a_file_that_was_never_fine_leaves_the_display_dark() -> Outcome {
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
fn the_camera_goes_so_far_and_back() -> Outcome {
    let here = Directory::new("camera")?;
    let mut workbench = workbench(&[here.write("scene.toml", SCENE)?], "ssd0323")?;
    for (there, back) in [(Key::Up, Key::Down), (Key::Farther, Key::Closer)] {
        for _ in 0..100 {
            workbench.press(there);
        }
        let farthest = drawn(&mut workbench);
        workbench.press(back);
        assert!(drawn(&mut workbench) != farthest, "{back:?}");
    }
    workbench.press(Key::Reset);
    assert_eq!(workbench.viewpoint, Viewpoint::default());
    Ok(())
}

#[test]
fn a_compiled_scene_is_orbited_as_its_file() -> Outcome {
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
fn keys_go_through_scenes_displays_formats_and_chips() -> Outcome {
    let here = Directory::new("keys")?;
    let files = [here.write("a.toml", SCENE)?, here.write("b.toml", SCENE)?];
    let mut workbench = workbench(&files, "ssd1306")?;
    let title = |workbench: &Workbench| workbench.status().title();
    assert_eq!(
        title(&workbench),
        "a (1 of 2) on ssd1306 128x64 binary, dither, linear, jagged, progressive"
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
        "b (2 of 2) on ssd0323 128x64 gray2, no dither, sRGB, 4 rays at edges, line by line"
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
fn edges_are_smoothed_once_all_else_is_drawn() -> Outcome {
    let here = Directory::new("edges")?;
    let mut workbench = workbench(&[here.write("scene.toml", SCENE)?], "ssd0323")?;
    let jagged = drawn(&mut workbench);
    let few = workbench.status().work.stats.camera;
    workbench.press(Key::Antialiasing);
    let smooth = drawn(&mut workbench);
    assert!(smooth != jagged);
    assert!(workbench.status().work.stats.camera > few);
    assert_eq!(workbench.status().percent, 100);
    for _ in 0..2 {
        workbench.press(Key::Antialiasing);
    }
    assert!(drawn(&mut workbench) == jagged);
    Ok(())
}
