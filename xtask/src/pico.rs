//! Runs the Raspberry Pi Pico's firmware in the emulator rp2040js.

mod button_test;
mod emulator;
mod firmware;
mod panel;
mod port;
mod slow_scenes;
mod transfers;

use std::fs::File;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use display_stream::Picture;
use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};

use crate::budget::Budget;
use emulator::Drawn;

const BUDGET: Budget = Budget {
    file: "boards/pico/budget.json",
    bless: "cargo xtask pico --bless",
};

/// Builds the firmware with a scene and runs it. Compares its picture with the host's picture. If
/// the file name `screenshot` is given, writes the picture to this PNG file.
pub fn draw(scene: &Path, screenshot: Option<&Path>) -> Result<()> {
    let elf = firmware::build(&[scene])?;
    let drawn = emulator::run(&elf, &[])?;
    let Drawn { picture, .. } = drawn.first().context("the firmware drew no picture")?;
    panel::compare(picture, &panel::draw_on_host(scene)?)?;
    firmware::print_size(&elf)?;
    match screenshot {
        Some(file) => write_png(picture, file),
        None => Ok(()),
    }
}

/// Tests whether the firmware draws correctly and handles buttons and USB transfers, even while it
/// draws slow scenes. Compares the cycles of the pictures with the budget.
pub fn check() -> Result<()> {
    firmware::lint()?;
    BUDGET.check(&button_test::run()?)?;
    slow_scenes::run(0.6)
}

/// Draws slow scenes for 20 seconds of the chip's time, and checks that the firmware feeds its
/// watchdog and handles buttons and USB transfers in time.
pub(crate) fn prove_slow_scenes() -> Result<()> {
    slow_scenes::run(20.0)
}

/// Stores the counted cycles as the budget.
pub fn bless() -> Result<()> {
    BUDGET.bless(&button_test::run()?)
}

/// Builds the firmware as a UF2 file. The firmware contains the given scenes, or the default scenes
/// if the list is empty.
pub fn uf2(scenes: &[PathBuf]) -> Result<()> {
    let scenes: Vec<_> = scenes.iter().map(PathBuf::as_path).collect();
    let file = firmware::uf2(&firmware::build(&scenes)?)?;
    println!("wrote {}", file.display());
    Ok(())
}

fn write_png(picture: &Picture, file: &Path) -> Result<()> {
    let colors = picture.pixels().iter().map(|pixel| Rgb888::from(*pixel));
    let bytes: Vec<u8> = colors
        .flat_map(|color| [color.r(), color.g(), color.b()])
        .collect();
    let target = File::create(file).with_context(|| file.display().to_string())?;
    let mut encoder = png::Encoder::new(target, panel::SIZE.width, panel::SIZE.height);
    encoder.set_color(png::ColorType::Rgb);
    Ok(encoder.write_header()?.write_image_data(&bytes)?)
}
