//! Describes the Pico's display, and draws the expected pictures on the host.

use std::path::Path;

use anyhow::{Result, bail};
use display_stream::{Panel, Picture};
use embedded_graphics::mono_font::ascii::FONT_10X20;
use embedded_graphics_core::geometry::Size;
use whitted::{PreparedScene, Real, Renderer, real};
use whitted_sim::scene_file::{self, Buffer};

/// Display of the Pico. It is mounted rotated by 90 degrees.
pub(super) const PANEL: Panel = Panel {
    madctl: 0x60,
    ..Panel::ST7789_240X240
};

pub(super) const SIZE: Size = Size::new(240, 240);

/// Angle by which a button rotates the camera, in degrees.
const STEP: Real = real!(15);

/// Draws a scene on the host.
pub(super) fn draw_on_host(scene: &Path) -> Result<Picture> {
    let compiled = scene_file::compile(scene)?;
    draw(&Buffer::new().decode(&compiled)?)
}

/// Moves the camera of a scene one step to the right and draws the scene on the host.
pub(super) fn draw_from_the_right(scene: &Path) -> Result<Picture> {
    let compiled = scene_file::compile(scene)?;
    let mut buffer = Box::new(Buffer::new());
    let mut scene = buffer.decode(&compiled)?;
    scene.set_camera(&scene.camera().orbited(STEP, Real::ZERO))?;
    draw(&scene)
}

fn draw(scene: &PreparedScene<'_>) -> Result<Picture> {
    let mut picture = Picture::new(SIZE);
    let Ok(()) = Renderer::new(scene, SIZE).draw(&mut picture);
    Ok(picture)
}

/// Draws the page that the Pico shows for an error message.
pub(super) fn message(text: &str) -> Result<Picture> {
    let mut picture = Picture::new(SIZE);
    message_page::write(&mut picture, &FONT_10X20, text)?;
    Ok(picture)
}

/// Compares two pictures. If they differ, returns an error that names the first different pixel.
pub(super) fn compare(shown: &Picture, expected: &Picture) -> Result<()> {
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
