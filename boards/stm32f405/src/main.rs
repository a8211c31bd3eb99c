//! Draws a scene on an ILI9341 display of 320x240 pixels, on an STM32F405.
//!
//! The build script compiles the scene file on the host. The firmware contains the compiled
//! scene. `board.rs` initializes the hardware.

#![no_std]
#![no_main]

mod board;

use cortex_m_rt::entry;
use defmt::{Display2Format, error, info};
use embedded_graphics::{mono_font::ascii::FONT_10X20, prelude::*};
use whitted::Renderer;
use whitted::render::{RenderProgress, Step};
use whitted::scene::SceneCounts;
use {defmt_rtt as _, panic_probe as _};

use board::Board;

/// The compiled scene in flash.
static SCENE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/scene.bin"));

/// Number of objects, lights and materials in the scene.
const COUNTS: SceneCounts = SceneCounts::of_compiled(SCENE);

#[entry]
fn main() -> ! {
    static mut BUFFER: whitted::scene_buffer!(COUNTS) = <whitted::scene_buffer!(COUNTS)>::new();
    // Transfer buffer of the display driver. It holds one line of 16-bit pixels.
    static mut LINE: [u8; 640] = [0; 640];

    let Board {
        mut display,
        mut watchdog,
    } = board::init(LINE);

    match BUFFER.decode(SCENE) {
        Ok(scene) => {
            let mut renderer = Renderer::new(&scene, display.size());
            // Progressive order draws blocks of 16x16 pixels first and single pixels last.
            let mut progress = RenderProgress::progressive(display.bounding_box());
            while !progress.is_complete() {
                match renderer.step(&mut progress, Step::Line, &mut display) {
                    Ok(()) => watchdog.feed(),
                    // After a display error, the next step sends the same line again. The
                    // watchdog is not fed, so it resets the chip if the display keeps
                    // failing.
                    Err(error) => error!("display error: {}", error),
                }
            }
            info!("picture complete");
        }
        Err(error) => {
            error!("invalid scene in flash: {}", Display2Format(&error));
            let text = format_args!("The scene in flash cannot be drawn: {error}.");
            _ = message_page::write(&mut display, &FONT_10X20, text);
        }
    }
    board::finish(watchdog)
}
