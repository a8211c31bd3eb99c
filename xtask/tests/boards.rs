//! What firmware sends to a display, against what the library draws here.

use std::fs;

use anyhow::Result;
use display_stream::Picture;
use embedded_graphics::mono_font::ascii::FONT_10X20;
use embedded_graphics::prelude::*;
use whitted::Renderer;
use whitted_sim::scene_file;
use xtask::board::{Board, STM32F405_IN_QEMU};
use xtask::{netduinoplus2, root, scratch_dir};

const LANDSCAPE: Size = Size::new(320, 240);

/// What a display of a board shows.
fn assert_equal(board: Board, shown: &Picture, expected: &Picture) {
    assert_eq!(shown.size(), expected.size(), "{}", board.name);
    assert_eq!(shown.first_difference(expected), None, "{}", board.name);
}

#[test]
fn the_stm32f405_shows_what_the_library_draws() -> Result<()> {
    let shown = netduinoplus2::draw(&STM32F405_IN_QEMU.build(None)?)?;

    let file = scene_file::load(root().join("scenes/whitted.toml"))?;
    let mut buffer = Box::new(scene_file::Buffer::new());
    let scene = file.prepare(&mut buffer)?;
    let mut expected = Picture::new(LANDSCAPE);
    let Ok(()) = Renderer::new(&scene, LANDSCAPE).draw(&mut expected);
    assert_equal(STM32F405_IN_QEMU, &shown, &expected);
    Ok(())
}

#[test]
fn the_stm32f405_shows_what_is_wrong_with_a_scene() -> Result<()> {
    let mut bytes = scene_file::compile(root().join("scenes/whitted.toml"))?;
    bytes[40] ^= 1;
    let broken = scratch_dir()?.join("broken.bin");
    fs::write(&broken, bytes)?;
    let shown = netduinoplus2::draw(&STM32F405_IN_QEMU.build(Some(&broken))?)?;

    let mut expected = Picture::new(LANDSCAPE);
    let text =
        "The scene in flash cannot be drawn: wrong checksum: the scene is damaged or truncated.";
    message_page::write(&mut expected, &FONT_10X20, text)?;
    assert_equal(STM32F405_IN_QEMU, &shown, &expected);
    Ok(())
}
