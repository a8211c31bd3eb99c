//! Draws scenes on the OLED of the LM3S6965 evaluation board.
//!
//! The arrow buttons orbit the camera around its target. The select button shows the next
//! scene. The build script compiles the scene files on the host. The firmware contains the
//! compiled scenes.

#![no_std]
#![no_main]

mod board;
mod buttons;
mod gpio;
mod panic;
mod pl022;
mod register;
mod ssd0323;
mod uart;

use core::fmt::Write;

use cortex_m_rt::entry;
use embedded_graphics::{mono_font::ascii::FONT_5X8, prelude::*};
use measure::{Checksum, Report};
use whitted::render::{RenderProgress, Step};
use whitted::{DecodeError, PreparedScene, Real, Renderer, real};

use board::Board;
use buttons::Button;

// The included file defines two items. `static SCENES: [&[u8]; N]` is a list of compiled
// scenes. `const COUNTS` is a buffer capacity that is large enough for each of these
// scenes.
include!(concat!(env!("OUT_DIR"), "/scenes.rs"));

/// Orbit angle per button press, in degrees.
const ORBIT_STEP: Real = real!(15);

#[entry]
fn main() -> ! {
    // `BUFFER` holds the prepared scene. `PIXELS` is the framebuffer of the display driver.
    static mut BUFFER: whitted::scene_buffer!(COUNTS) = <whitted::scene_buffer!(COUNTS)>::new();
    static mut PIXELS: ssd0323::Pixels = ssd0323::BLACK;

    let mut board = Board::new(PIXELS);
    loop {
        for scene in SCENES {
            match BUFFER.decode(scene) {
                Ok(mut scene) => show(&mut scene, &mut board),
                Err(error) => show_error(error, &mut board),
            }
        }
    }
}

/// Shows a scene and lets the user move the camera. Returns when the select button is
/// pressed.
fn show(scene: &mut PreparedScene<'_>, board: &mut Board) {
    loop {
        match draw(scene, board) {
            Button::Up => orbit(scene, Real::ZERO, ORBIT_STEP),
            Button::Down => orbit(scene, Real::ZERO, -ORBIT_STEP),
            Button::Left => orbit(scene, -ORBIT_STEP, Real::ZERO),
            Button::Right => orbit(scene, ORBIT_STEP, Real::ZERO),
            Button::Select => return,
        }
    }
}

/// Orbits the camera around its target by angles in degrees.
#[inline(never)] // keeps the locals of `orbit` off the stack while a picture is drawn
fn orbit(scene: &mut PreparedScene<'_>, yaw: Real, pitch: Real) {
    let camera = scene.camera().orbited(yaw, pitch);
    // If the new position is invalid, `set_camera` returns an error and the camera does not
    // move.
    _ = scene.set_camera(&camera);
}

/// Draws a picture in progressive order. Returns the first button that the user presses,
/// either while the picture is drawn or afterwards.
///
/// After the last pass, the function traces the picture again for its checksum and prints a
/// report on the UART.
fn draw(scene: &PreparedScene<'_>, board: &mut Board) -> Button {
    let mut renderer = Renderer::new(scene, board.oled.size());
    let mut progress = RenderProgress::progressive(board.oled.bounding_box());
    let mut checksum = Checksum::default();
    board.stopwatch.restart();
    loop {
        if let Some(button) = board.buttons.take_press() {
            return button;
        }
        if !progress.is_complete() {
            let Ok(()) = renderer.step(&mut progress, Step::Line, &mut board.oled);
            board.stopwatch.lap();
        } else if let Some(checksum) = checksum.line(&mut renderer) {
            let report = Report::new(renderer.size(), &board.stopwatch).with_checksum(checksum);
            let framebuffer = size_of::<ssd0323::Pixels>();
            // Writing to the UART never fails.
            _ = write!(
                board.uart,
                "{report}framebuffer: {framebuffer}\n{}\n",
                measure::END
            );
            return board.buttons.wait();
        }
    }
}

/// Shows the reason why a scene cannot be drawn. Returns when the select button is pressed.
#[inline(never)] // keeps the locals of `show_error` off the stack while a picture is drawn
fn show_error(error: DecodeError, board: &mut Board) {
    let text = format_args!("The scene in flash cannot be drawn: {error}.");
    _ = message_page::write(&mut board.oled, &FONT_5X8, text);
    _ = write!(board.uart, "error: {error}\n{}\n", measure::END);
    while !matches!(board.buttons.wait(), Button::Select) {}
}
