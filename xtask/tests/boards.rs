//! Pictures on the STM32F405's display, compared with the host's.

use std::fs;

use anyhow::Result;
use display_stream::Picture;
use embedded_graphics::mono_font::ascii::FONT_10X20;
use embedded_graphics::prelude::*;
use whitted::Renderer;
use whitted_sim::scene_file;
use xtask::board::STM32F405_IN_QEMU;
use xtask::{gallery_scene, host, netduinoplus2, scene, scratch_dir};

const SIZE: Size = Size::new(320, 240);

fn assert_equal(shown: &Picture, expected: &Picture) {
    assert_eq!(shown.size(), expected.size());
    assert_eq!(shown.first_difference(expected), None);
}

#[test]
fn shows_the_picture_of_the_host() -> Result<()> {
    let shown = netduinoplus2::draw(&STM32F405_IN_QEMU.build(None)?)?;

    let file = scene_file::load(gallery_scene("whitted"))?;
    let mut buffer = Box::new(scene_file::Buffer::new());
    let prepared = file.prepare(&mut buffer)?;
    let mut expected = Picture::new(SIZE);
    let Ok(()) = Renderer::new(&prepared, SIZE).draw(&mut expected);
    assert_equal(&shown, &expected);
    Ok(())
}

#[test]
fn shows_the_error_of_a_damaged_scene() -> Result<()> {
    let mut bytes = scene_file::compile(scene("whitted"))?;
    bytes[40] ^= 1;
    let damaged = scratch_dir()?.join("damaged.bin");
    fs::write(&damaged, &bytes)?;
    let shown = netduinoplus2::draw(&STM32F405_IN_QEMU.build(Some(&damaged))?)?;

    let mut expected = Picture::new(SIZE);
    let error = host::decode_error(&bytes)?;
    let text = format!("The scene in flash cannot be drawn: {error}.");
    message_page::write(&mut expected, &FONT_10X20, &text)?;
    assert_equal(&shown, &expected);
    Ok(())
}
