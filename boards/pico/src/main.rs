//! Draws scenes on the display of a Raspberry Pi Pico.
//!
//! The scenes are compiled on the host and lie in flash, see `build.rs`, or come over
//! USB. The stick moves the camera around what it looks at, a button shows the next
//! scene.

#![no_std]
#![no_main]

mod board;
mod buttons;
mod pins;
mod scenes;
mod usb;

// The logger, and what tells of a panic.
use {defmt_rtt as _, panic_probe as _};

use defmt::Display2Format;
use embedded_graphics::{mono_font::ascii::FONT_10X20, prelude::*};
use embedded_hal::digital::OutputPin;
use rp2040_hal::entry;
use whitted::render::{RenderProgress, Step};
use whitted::{DecodeError, PreparedScene, Real, Renderer};

use board::{Board, Event, LineBuffer};
use buttons::Button;
use scenes::{Buffer, Scenes};
use usb::Inbox;

/// How far the stick moves the camera, in degrees.
const STEP: Real = Real::lit("15");

#[entry]
fn main() -> ! {
    // Room for the scenes, for one on its way, for the one that is drawn, and for what
    // goes to the display at once.
    static mut SCENES: Scenes = Scenes::new();
    static mut INBOX: Inbox = Inbox::new();
    static mut BUFFER: Buffer = Buffer::new();
    static mut LINE: LineBuffer = [0; size_of::<LineBuffer>()];

    let mut board = Board::take(LINE, SCENES, INBOX);
    let mut number = 0;
    loop {
        let count = board.scenes.count();
        defmt::info!("scene {=usize} of {=usize}", number + 1, count);
        let event = match BUFFER.decode(board.scenes.get(number)) {
            Ok(mut scene) => explore(&mut scene, &mut board),
            Err(error) => complain(error, &mut board),
        };
        number = match event {
            Event::Sent(number) => number,
            Event::Press(_) => (number + 1) % count,
        };
    }
}

/// Draws the scene from wherever it is to be looked at, until another is asked for.
fn explore(scene: &mut PreparedScene<'_>, board: &mut Board) -> Event {
    loop {
        let event = draw(scene, board).unwrap_or_else(|| board.wait());
        let (yaw, pitch) = match event {
            Event::Press(Button::Left) => (-STEP, Real::ZERO),
            Event::Press(Button::Right) => (STEP, Real::ZERO),
            Event::Press(Button::Up) => (Real::ZERO, STEP),
            Event::Press(Button::Down) => (Real::ZERO, -STEP),
            Event::Press(Button::Next) | Event::Sent(_) => return event,
        };
        if let Err(error) = scene.set_camera(&scene.camera().orbited(yaw, pitch)) {
            defmt::warn!("the camera stays: {}", Display2Format(&error));
        }
    }
}

/// Draws a picture, coarsely first, unless something is asked for meanwhile.
fn draw(scene: &PreparedScene<'_>, board: &mut Board) -> Option<Event> {
    let mut renderer = Renderer::new(scene, board.display.size());
    let mut drawing = RenderProgress::progressive(board.display.bounding_box());
    let mut event = None;
    let Ok(()) = board.led.set_high();
    while !drawing.is_complete() && event.is_none() {
        let Ok(()) = renderer.step(&mut drawing, Step::Line, &mut board.display);
        event = board.event();
    }
    let Ok(()) = board.led.set_low();
    event
}

/// Says why a scene cannot be drawn, until another is asked for.
fn complain(error: DecodeError, board: &mut Board) -> Event {
    defmt::error!("it cannot be drawn: {}", Display2Format(&error));
    let text = format_args!("This scene cannot be drawn: {error}.");
    let Ok(()) = board.led.set_high();
    // A display that takes no text cannot be told anything.
    _ = message_page::write(&mut board.display, &FONT_10X20, text);
    let Ok(()) = board.led.set_low();
    loop {
        let event = board.wait();
        if matches!(event, Event::Press(Button::Next) | Event::Sent(_)) {
            return event;
        }
    }
}
