//! Draws scenes on an ST7789 display of 240x240 pixels, on a Raspberry Pi Pico.
//!
//! The build script compiles the scene files on the host. The firmware contains the
//! compiled scenes and receives more scenes over USB. The joystick orbits the camera around
//! its target. A button shows the next scene.

#![no_std]
#![no_main]

mod board;
mod buttons;
mod input;
mod pins;
mod scenes;
mod usb;

// These crates provide the logger and the panic handler.
use {defmt_rtt as _, panic_probe as _};

use core::ops::ControlFlow;

use defmt::Display2Format;
use embedded_graphics::{mono_font::ascii::FONT_10X20, prelude::*};
use embedded_hal::digital::OutputPin;
use rp2040_hal::entry;
use whitted::observer::Poller;
use whitted::render::{RenderProgress, Step};
use whitted::{DecodeError, PreparedScene, Real, Renderer, real};

use board::{Board, LineBuffer};
use buttons::Button;
use input::Event;
use scenes::{Buffer, Scenes};
use usb::SceneReceiver;

/// Orbit angle per joystick press, in degrees.
const ORBIT_STEP: Real = real!(15);

/// Number of rays and intersection tests after which the firmware polls for input again and feeds
/// the watchdog.
const POLL_INTERVAL: u32 = 200;

#[entry]
fn main() -> ! {
    // The scenes in flash, and the last scene that arrived over USB.
    static mut SCENES: Scenes = Scenes::new();
    // Memory for the scene that is being received over USB.
    static mut RECEIVER: SceneReceiver = SceneReceiver::new();
    // Memory for the prepared scene that is drawn.
    static mut BUFFER: Buffer = Buffer::new();
    // Memory to validate a received scene.
    static mut VALIDATION_BUFFER: Buffer = Buffer::new();
    static mut LINE: LineBuffer = [0; size_of::<LineBuffer>()];

    let mut board = Board::new(LINE, RECEIVER, VALIDATION_BUFFER);
    let mut index = 0;
    loop {
        let count = SCENES.count();
        defmt::info!("scene {=usize} of {=usize}", index + 1, count);
        let event = match BUFFER.decode(SCENES.get(index)) {
            Ok(mut scene) => show_scene(&mut scene, &mut board),
            Err(error) => show_error(error, &mut board),
        };
        index = match event {
            Event::Received => SCENES.store_received(),
            Event::Press(_) => (index + 1) % count,
        };
    }
}

/// Shows a scene and lets the user move the camera. Returns when another scene is selected.
fn show_scene(scene: &mut PreparedScene<'_>, board: &mut Board) -> Event {
    loop {
        let event = draw(scene, board).unwrap_or_else(|| board.input.wait());
        let (yaw, pitch) = match event {
            Event::Press(Button::Left) => (-ORBIT_STEP, Real::ZERO),
            Event::Press(Button::Right) => (ORBIT_STEP, Real::ZERO),
            Event::Press(Button::Up) => (Real::ZERO, ORBIT_STEP),
            Event::Press(Button::Down) => (Real::ZERO, -ORBIT_STEP),
            Event::Press(Button::Next) | Event::Received => return event,
        };
        if let Err(error) = scene.set_camera(&scene.camera().orbited(yaw, pitch)) {
            defmt::warn!("the camera cannot move there: {}", Display2Format(&error));
        }
    }
}

/// Draws a picture in progressive order. On user input, even inside a pixel, this function
/// stops drawing and returns the input event.
fn draw(scene: &PreparedScene<'_>, board: &mut Board) -> Option<Event> {
    let Board {
        display,
        led,
        input,
    } = board;
    let mut event = None;
    let poller = Poller::new(POLL_INTERVAL, || {
        event = input.poll();
        match event {
            Some(_) => ControlFlow::Break(()),
            None => ControlFlow::Continue(()),
        }
    });
    let mut renderer = Renderer::with_observer(scene, display.size(), poller);
    let mut progress = RenderProgress::progressive(display.bounding_box());
    let Ok(()) = led.set_high();
    while !progress.is_complete() && !renderer.observer().is_interrupted() {
        let Ok(()) = renderer.step(&mut progress, Step::Pass, display);
    }
    let Ok(()) = led.set_low();
    event
}

/// Shows the reason why a scene cannot be drawn. Returns when another scene is selected.
fn show_error(error: DecodeError, board: &mut Board) -> Event {
    defmt::error!("invalid scene: {}", Display2Format(&error));
    let text = format_args!("This scene cannot be drawn: {error}.");
    let Ok(()) = board.led.set_high();
    // Writing to the display never fails.
    _ = message_page::write(&mut board.display, &FONT_10X20, text);
    let Ok(()) = board.led.set_low();
    loop {
        let event = board.input.wait();
        if matches!(event, Event::Press(Button::Next) | Event::Received) {
            return event;
        }
    }
}
