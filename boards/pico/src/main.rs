//! Draws scenes on the display of a Raspberry Pi Pico.
//!
//! The scenes are compiled on the host and lie in flash; see `build.rs`. The stick
//! moves the camera around what it looks at, a button shows the next scene.

#![no_std]
#![no_main]

mod board;
mod buttons;
mod pins;
mod scenes;

// The logger, and what tells of a panic.
use {defmt_rtt as _, panic_probe as _};

use defmt::Display2Format;
use embedded_graphics::{mono_font::ascii::FONT_10X20, prelude::*};
use embedded_hal::digital::OutputPin;
use rp2040_hal::entry;
use whitted::{Camera, Drawing, PreparedScene, Real, Renderer, Step};

use board::{Board, LineBuffer};
use buttons::Button;
use scenes::{Buffer, SCENES};

/// How far the stick moves the camera, in degrees.
const STEP: Real = Real::lit("15");

#[entry]
fn main() -> ! {
    // Room for a scene, and for what goes to the display at once.
    static mut BUFFER: Buffer = Buffer::new();
    static mut LINE: LineBuffer = [0; size_of::<LineBuffer>()];

    let mut board = Board::take(LINE);
    for (number, scene) in SCENES.iter().enumerate().cycle() {
        defmt::info!("scene {=usize} of {=usize}", number + 1, SCENES.len());
        match BUFFER.decode(scene.compiled) {
            Ok(mut prepared) => explore(&mut prepared, scene.camera, &mut board),
            Err(error) => {
                defmt::error!("it cannot be drawn: {}", Display2Format(&error));
                let text = format_args!("This scene cannot be drawn: {error}.");
                // A display that takes no text cannot be told anything.
                _ = page::write(&mut board.display, &FONT_10X20, text);
                while board.button() != Button::Next {}
            }
        }
    }
    unreachable!("after the last scene comes the first")
}

/// Draws the scene from wherever it is to be looked at, until the next is asked for.
fn explore(scene: &mut PreparedScene<'_>, mut camera: Camera, board: &mut Board) {
    loop {
        let button = draw(scene, board).unwrap_or_else(|| board.button());
        let moved = match button {
            Button::Left => camera.orbited(-STEP, Real::ZERO),
            Button::Right => camera.orbited(STEP, Real::ZERO),
            Button::Up => camera.orbited(Real::ZERO, STEP),
            Button::Down => camera.orbited(Real::ZERO, -STEP),
            Button::Next => return,
        };
        match scene.set_camera(&moved) {
            Ok(()) => camera = moved,
            Err(error) => defmt::warn!("the camera stays: {}", Display2Format(&error)),
        }
    }
}

/// Draws a picture, coarsely first, unless a button is pressed meanwhile.
fn draw(scene: &PreparedScene<'_>, board: &mut Board) -> Option<Button> {
    let mut renderer = Renderer::new(scene, board.display.size());
    let mut drawing = Drawing::progressive(board.display.bounding_box());
    let mut pressed = None;
    let Ok(()) = board.led.set_high();
    while !drawing.is_complete() && pressed.is_none() {
        let Ok(()) = renderer.step(&mut drawing, Step::Line, &mut board.display);
        board.watchdog.feed();
        pressed = board.buttons.pressed();
    }
    let Ok(()) = board.led.set_low();
    pressed
}
