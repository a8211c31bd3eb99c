//! The Raspberry Pi Pico: its firmware, in the emulator rp2040js.

mod budget;
mod emulator;
mod firmware;

use std::path::Path;

use anyhow::{Context, Result, bail};
use display_stream::{Panel, Picture};
use embedded_graphics_core::geometry::Size;
use whitted::{PreparedScene, Real, Renderer};
use whitted_sim::scene_file::{self, Buffer};

use crate::root;
use emulator::{Button, Drawn};

/// The panel of the hat, which lies on its side.
const PANEL: Panel = Panel {
    upright: 0x60,
    ..Panel::ST7789_240X240
};
const SIZE: Size = Size::new(240, 240);

/// How far a button moves the camera, in degrees.
const STEP: Real = Real::lit("15");

/// Builds the firmware with a scene of the person's, runs it until it has drawn
/// it, and writes what the display shows to a PNG file.
pub fn draw(scene: &Path, screenshot: Option<&Path>) -> Result<()> {
    let elf = firmware::build(&[scene])?;
    let drawn = one(emulator::run(&elf, &[])?)?;
    is_the_hosts(&drawn.picture, &on_the_host(scene, |_| Ok(()))?)?;
    println!("cycles: {}", drawn.cycles);
    firmware::print_size(&elf)?;
    match screenshot {
        Some(file) => write_png(&drawn.picture, file),
        None => Ok(()),
    }
}

/// Fails unless the firmware shows what the host draws, in as many cycles as
/// are committed, and does what its buttons are for.
pub fn check() -> Result<()> {
    firmware::lint()?;
    let drawn = draw_all()?;
    budget::check(&drawn)
}

/// Builds the firmware with these scenes, or those that it has by default, as a file
/// to be dropped on the Pico.
pub fn uf2(scenes: &[std::path::PathBuf]) -> Result<()> {
    let scenes: Vec<&Path> = scenes.iter().map(|scene| scene.as_path()).collect();
    let file = firmware::uf2(&firmware::build(&scenes)?)?;
    println!("wrote {}", file.display());
    Ok(())
}

/// Makes the cycles that pictures take now the budget.
pub fn bless() -> Result<()> {
    budget::bless(&draw_all()?)
}

/// Draws the first scene, then the second, then that from its right.
fn draw_all() -> Result<Vec<(&'static str, u64)>> {
    let [first, second] = ["four_spheres", "bouncing_ball"];
    let file = |scene| root().join(format!("scenes/{scene}.toml"));
    let elf = firmware::build(&[&file(first), &file(second)])?;
    firmware::print_size(&elf)?;

    let camera = scene_file::load(file(second))?.scene().camera;
    let expected = [
        on_the_host(&file(first), |_| Ok(()))?,
        on_the_host(&file(second), |_| Ok(()))?,
        on_the_host(&file(second), |scene| {
            Ok(scene.set_camera(&camera.orbited(STEP, Real::ZERO))?)
        })?,
    ];
    let drawn = emulator::run(&elf, &[Button::Next, Button::Right])?;
    let names = [first, second, "from the right"];
    for ((name, drawn), expected) in names.iter().zip(&drawn).zip(&expected) {
        is_the_hosts(&drawn.picture, expected).with_context(|| format!("picture {name}"))?;
    }
    if drawn.len() != names.len() {
        bail!("{} pictures in place of {}", drawn.len(), names.len());
    }
    Ok(names
        .into_iter()
        .zip(drawn.iter().map(|drawn| drawn.cycles))
        .collect())
}

/// What the library draws of a scene into a display like that, on the host.
fn on_the_host(
    scene: &Path,
    change: impl FnOnce(&mut PreparedScene<'_>) -> Result<()>,
) -> Result<Picture> {
    let compiled = scene_file::compile(scene)?;
    let mut buffer = Box::new(Buffer::new());
    let mut scene = buffer.decode(&compiled)?;
    change(&mut scene)?;
    let mut picture = Picture::new(SIZE);
    let Ok(()) = Renderer::new(&scene, SIZE).draw(&mut picture);
    Ok(picture)
}

fn is_the_hosts(shown: &Picture, expected: &Picture) -> Result<()> {
    let Some(at) = shown.first_difference(expected) else {
        return Ok(());
    };
    bail!(
        "the display shows {:?} at ({}, {}), the host draws {:?}",
        shown.pixel(at),
        at.x,
        at.y,
        expected.pixel(at)
    )
}

fn one(drawn: Vec<Drawn>) -> Result<Drawn> {
    drawn.into_iter().next().context("no picture was drawn")
}

fn write_png(picture: &Picture, file: &Path) -> Result<()> {
    use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
    let color = |pixel| Rgb888::from(pixel);
    let bytes = picture.pixels().iter().map(|pixel| color(*pixel));
    let bytes: Vec<u8> = bytes
        .flat_map(|color| [color.r(), color.g(), color.b()])
        .collect();
    let target = std::fs::File::create(file).with_context(|| file.display().to_string())?;
    let mut encoder = png::Encoder::new(target, SIZE.width, SIZE.height);
    encoder.set_color(png::ColorType::Rgb);
    Ok(encoder.write_header()?.write_image_data(&bytes)?)
}
