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
mod page;
mod panic;
mod pl022;
mod register;
mod ssd0323;
mod uart;

use core::fmt::Write;

use cortex_m_rt::entry;
use embedded_graphics::{pixelcolor::Gray4, prelude::*};
use measure::{Checksum, Report};
use whitted::{
    Camera, DecodeError, Drawing, PreparedScene, Real, Renderer, SceneBuffer, Step, Vec3,
};

use board::Board;
use buttons::Button;
use page::Page;

/// A scene in flash.
struct Stored {
    /// What [`SceneBuffer::decode`] reads.
    compiled: &'static [u8],
    /// Its camera, which the arrow buttons move.
    camera: Option<Camera>,
}

// `static SCENES: [Stored; N]`, and `const COUNTS`, the room that any of them takes.
include!(concat!(env!("OUT_DIR"), "/scenes.rs"));

/// How far a press of an arrow button goes, in degrees.
const TURN: Real = Real::lit("15");

#[entry]
fn main() -> ! {
    // Room for a scene, and the display driver's copy of its pixels.
    static mut BUFFER: SceneBuffer<{ COUNTS[0] }, { COUNTS[1] }, { COUNTS[2] }> =
        SceneBuffer::new();
    static mut PIXELS: ssd0323::Pixels = ssd0323::BLACK;

    let mut board = Board::new(PIXELS);
    loop {
        for stored in &SCENES {
            match BUFFER.decode(stored.compiled) {
                Ok(mut scene) => show(&mut scene, stored.camera, &mut board),
                Err(error) => complain(error, &mut board),
            }
        }
    }
}

/// Shows a scene from wherever the arrow buttons lead, until the select button
/// is pressed.
fn show(scene: &mut PreparedScene<'_>, mut camera: Option<Camera>, board: &mut Board) {
    loop {
        match (draw(scene, board), &mut camera) {
            (Button::Select, _) => return,
            (arrow, Some(camera)) => orbit(scene, camera, arrow),
            (_, None) => {}
        }
    }
}

/// Moves the camera. Where it cannot go, it stays.
#[inline(never)] // else its variables would take stack while a picture is drawn
fn orbit(scene: &mut PreparedScene<'_>, camera: &mut Camera, arrow: Button) {
    let [right, up] = match arrow {
        Button::Up => [Real::ZERO, TURN],
        Button::Down => [Real::ZERO, -TURN],
        Button::Left => [-TURN, Real::ZERO],
        Button::Right => [TURN, Real::ZERO],
        Button::Select => return,
    };
    let moved = camera.orbited(right, up);
    if scene.set_camera(&moved).is_ok() {
        *camera = moved;
    }
}

/// Draws a picture, the whole of it at once, then in ever more detail, and tells
/// about it on the UART; until a button is pressed.
fn draw(scene: &PreparedScene<'_>, board: &mut Board) -> Button {
    let mut renderer = Renderer::new(scene, board.oled.size());
    let mut drawing = Drawing::progressive(board.oled.bounding_box());
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
    let Ok(()) = board.oled.clear(Gray4::BLACK);
    let mut page = Page::new(&mut board.oled);
    _ = write!(page, "The scene in flash cannot be drawn: {error}.");
    _ = write!(board.uart, "error: {error}\n{}\n", measure::END);
    while !matches!(board.buttons.wait(), Button::Select) {}
}
