//! The Raspberry Pi Pico: its firmware, in the emulator rp2040js.

mod budget;
mod emulator;
mod firmware;
mod port;
mod transfers;

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};
use display_stream::{Panel, Picture};
use embedded_graphics::mono_font::ascii::FONT_10X20;
use embedded_graphics_core::geometry::Size;
use whitted::{PreparedScene, Real, Renderer};
use whitted_sim::scene_file::{self, Buffer};

use crate::{root, scratch_dir};
use emulator::{Button, Cost, Drawn, Event};

/// The panel of the hat, which lies on its side.
const PANEL: Panel = Panel {
    madctl: 0x60,
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
    is_the_hosts(&drawn.picture, &on_the_host(scene)?)?;
    println!("{}", drawn.cost);
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
    for (name, cost) in &drawn {
        println!("{name}: {cost}");
    }
    budget::check(&cycles(&drawn))
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
    budget::bless(&cycles(&draw_all()?))
}

fn cycles(drawn: &[(&'static str, Cost)]) -> Vec<(&'static str, u64)> {
    let of = |(name, cost): &(&'static str, Cost)| (*name, cost.cycles);
    drawn.iter().map(of).collect()
}

/// Does with the firmware all that can be done, and compares each picture that is not
/// broken off with the host's. Gives what some took.
fn draw_all() -> Result<Vec<(&'static str, Cost)>> {
    let file = |scene| root().join(format!("scenes/{scene}.toml"));
    let (first, last, sent) = (
        file("four_spheres"),
        file("bouncing_ball"),
        file("still_life"),
    );
    let elf = firmware::build(&[&first, &broken(&first)?, &last])?;
    firmware::print_size(&elf)?;

    let program = transfers::program()?;
    let transfer = |port: &port::Port| {
        transfers::break_off(port, &sent)?;
        transfers::send(&program, port, &sent)
    };
    let events = [
        Event::Press(Button::Next),
        Event::Press(Button::Next),
        Event::Amid(Button::Right),
        Event::Usb(&transfer),
        // What was sent comes after the scenes in flash.
        Event::Amid(Button::Next),
        Event::Amid(Button::Next),
        Event::Press(Button::Next),
        Event::Amid(Button::Next),
    ];
    let error = "This scene cannot be drawn: wrong checksum: the scene is damaged or truncated.";
    let expected = [
        ("four_spheres", Some(on_the_host(&first)?)),
        ("an error", Some(text(error)?)),
        ("broken off", None),
        ("from the right", Some(from_the_right(&last)?)),
        ("sent", None),
        ("four_spheres again", None),
        ("an error again", Some(text(error)?)),
        ("bouncing_ball", None),
        ("still_life", Some(on_the_host(&sent)?)),
    ];
    let drawn = emulator::run(&elf, &events)?;
    if drawn.len() != expected.len() {
        bail!("{} pictures in place of {}", drawn.len(), expected.len());
    }
    let mut costs = Vec::new();
    for (drawn, (name, expected)) in drawn.iter().zip(expected) {
        match expected {
            Some(expected) => is_the_hosts(&drawn.picture, &expected),
            None => is_broken_off(drawn),
        }
        .with_context(|| format!("picture {name}"))?;
        costs.push((name, drawn.cost));
    }
    costs.retain(|(name, _)| budget::PICTURES.contains(name));
    Ok(costs)
}

/// A scene with a bit flipped, compiled.
fn broken(scene: &Path) -> Result<PathBuf> {
    let mut bytes = scene_file::compile(scene)?;
    bytes[40] ^= 1;
    let file = scratch_dir()?.join("broken-on-the-pico.bin");
    fs::write(&file, bytes)?;
    Ok(file)
}

/// What the library draws of a scene into a display like that, on the host.
fn on_the_host(scene: &Path) -> Result<Picture> {
    let compiled = scene_file::compile(scene)?;
    let mut buffer = Box::new(Buffer::new());
    picture(&buffer.decode(&compiled)?)
}

/// The same after the stick was moved to the right.
fn from_the_right(scene: &Path) -> Result<Picture> {
    let compiled = scene_file::compile(scene)?;
    let mut buffer = Box::new(Buffer::new());
    let mut scene = buffer.decode(&compiled)?;
    scene.set_camera(&scene.camera().orbited(STEP, Real::ZERO))?;
    picture(&scene)
}

fn picture(scene: &PreparedScene<'_>) -> Result<Picture> {
    let mut picture = Picture::new(SIZE);
    let Ok(()) = Renderer::new(scene, SIZE).draw(&mut picture);
    Ok(picture)
}

fn text(text: &str) -> Result<Picture> {
    let mut picture = Picture::new(SIZE);
    message_page::write(&mut picture, &FONT_10X20, text)?;
    Ok(picture)
}

/// A picture that a button breaks off ends with the line that it is at.
fn is_broken_off(drawn: &Drawn) -> Result<()> {
    /// The emulator presses after 20 M cycles.
    const MOST: u64 = 30_000_000;
    let Cost { cycles, .. } = drawn.cost;
    if cycles > MOST {
        bail!("it was drawn for {cycles} cycles");
    }
    Ok(())
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
