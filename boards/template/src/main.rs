//! Draws a scene on an ST7789 display of 240x240 pixels, on an STM32F411.
//!
//! The build script compiles `scene.toml` on the host. The firmware contains the compiled scene.
//! `board.rs` defines and initializes the hardware.

#![no_std]
#![no_main]

mod board;

use core::ops::ControlFlow;

use cortex_m_rt::entry;
use defmt::{Display2Format, error, info};
use embedded_graphics::{mono_font::ascii::FONT_10X20, prelude::*};
use whitted::Renderer;
use whitted::observer::Poller;
use whitted::render::{RenderProgress, Step};
use whitted::scene::SceneCounts;
use {defmt_rtt as _, panic_probe as _};

use board::Board;

/// The compiled scene in flash.
static SCENE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/scene.bin"));

/// Number of objects, lights and materials in the scene.
const COUNTS: SceneCounts = SceneCounts::of_compiled(SCENE);

/// Number of rays and intersection tests after which the firmware feeds the watchdog again.
const FEED_INTERVAL: u32 = 200;

/// Number of display errors in a row after which the firmware panics. The watchdog then resets the
/// chip.
const MAX_FAILURES: u32 = 10;

#[entry]
fn main() -> ! {
    static mut BUFFER: whitted::scene_buffer!(COUNTS) = <whitted::scene_buffer!(COUNTS)>::new();
    // Transfer buffer of the display driver. It holds one line of 320 pixels with 16 bits.
    static mut LINE: [u8; 640] = [0; 640];

    let Board {
        mut display,
        mut watchdog,
        mut led,
    } = board::init(LINE);

    led.set_low();
    match BUFFER.decode(SCENE) {
        Ok(scene) => {
            // A line of a slow scene can take minutes. The watchdog is therefore fed while rays
            // are traced, not after each line.
            let poller = Poller::new(FEED_INTERVAL, || {
                watchdog.feed();
                ControlFlow::Continue(())
            });
            let mut renderer = Renderer::with_observer(&scene, display.size(), poller);
            // Progressive order draws blocks of 16x16 pixels first and single pixels last.
            let mut progress = RenderProgress::progressive(display.bounding_box());
            let mut failures = 0;
            while !progress.is_complete() {
                match renderer.step(&mut progress, Step::Line, &mut display) {
                    Ok(()) => failures = 0,
                    // The next step sends the same line again.
                    Err(error) => {
                        error!("display error: {}", error);
                        failures += 1;
                    }
                }
                if failures == MAX_FAILURES {
                    defmt::panic!("the display keeps failing");
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
    led.set_high();
    loop {
        watchdog.feed();
    }
}
