//! Draws scenes on the OLED of the LM3S6965 evaluation board: the arrow buttons
//! move the camera around what it looks at, the select button shows the next
//! scene.
//!
//! The scenes are compiled on the host and lie in flash; see `build.rs`.

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
use whitted::{DecodeError, PreparedScene, Real, Renderer};

use board::Board;
use buttons::Button;

// The compiled scenes: `static SCENES: [&[u8]; N]`; and `const COUNTS`, the room
// that any of them takes.
include!(concat!(env!("OUT_DIR"), "/scenes.rs"));

/// How far a press of an arrow button goes, in degrees.
const TURN: Real = Real::lit("15");

#[entry]
fn main() -> ! {
    // Room for a scene, and the display driver's copy of its pixels.
    static mut BUFFER: whitted::scene_buffer!(COUNTS) = <whitted::scene_buffer!(COUNTS)>::new();
    static mut PIXELS: ssd0323::Pixels = ssd0323::BLACK;

    let mut board = Board::new(PIXELS);
    loop {
        for scene in SCENES {
            match BUFFER.decode(scene) {
                Ok(mut scene) => show(&mut scene, &mut board),
                Err(error) => complain(error, &mut board),
            }
        }
    }
}

/// Shows a scene from wherever the arrow buttons lead, until the select button
/// is pressed.
fn show(scene: &mut PreparedScene<'_>, board: &mut Board) {
    loop {
        match draw(scene, board) {
            Button::Up => orbit(scene, Real::ZERO, TURN),
            Button::Down => orbit(scene, Real::ZERO, -TURN),
            Button::Left => orbit(scene, -TURN, Real::ZERO),
            Button::Right => orbit(scene, TURN, Real::ZERO),
            Button::Select => return,
        }
    }
}

/// Moves the camera around what it looks at.
#[inline(never)] // else its variables would take stack while a picture is drawn
fn orbit(scene: &mut PreparedScene<'_>, yaw: Real, pitch: Real) {
    let camera = scene.camera().orbited(yaw, pitch);
    // Where it cannot go, it stays.
    _ = scene.set_camera(&camera);
}

/// Draws a picture, the whole of it at once, then in ever more detail, and tells
/// about it on the UART; until a button is pressed.
fn draw(scene: &PreparedScene<'_>, board: &mut Board) -> Button {
    let mut renderer = Renderer::new(scene, board.oled.size());
    let mut drawing = RenderProgress::progressive(board.oled.bounding_box());
    let mut checksum = Checksum::default();
    board.stopwatch.restart();
    loop {
        if let Some(button) = board.buttons.pressed() {
            return button;
        }
        if !drawing.is_complete() {
            let Ok(()) = renderer.step(&mut drawing, Step::Line, &mut board.oled);
            board.stopwatch.lap();
        } else if let Some(checksum) = checksum.line(&mut renderer) {
            let report = Report::new(renderer.size(), &board.stopwatch).with_checksum(checksum);
            let framebuffer = size_of::<ssd0323::Pixels>();
            // The UART cannot fail, so what `write!` returns says nothing.
            _ = write!(
                board.uart,
                "{report}framebuffer: {framebuffer}\n{}\n",
                measure::END
            );
            return board.buttons.wait();
        }
    }
}

/// Tells why a scene cannot be drawn, until the select button is pressed.
#[inline(never)] // as above
fn complain(error: DecodeError, board: &mut Board) {
    let text = format_args!("The scene in flash cannot be drawn: {error}.");
    _ = message_page::write(&mut board.oled, &FONT_5X8, text);
    _ = write!(board.uart, "error: {error}\n{}\n", measure::END);
    while !matches!(board.buttons.wait(), Button::Select) {}
}
