//! Draws a scene on an ILI9341 display of 320x240 pixels, at SPI 1 of an STM32F405.
//!
//! The scene is compiled on the host and lies in flash; see `build.rs`.

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

/// The scene, compiled.
static SCENE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/scene.bin"));
const COUNTS: SceneCounts = SceneCounts::of_compiled(SCENE);

#[entry]
fn main() -> ! {
    // Room for the scene, and for pixels on their way to the display.
    static mut BUFFER: whitted::scene_buffer!(COUNTS) = <whitted::scene_buffer!(COUNTS)>::new();
    static mut PIXELS: [u8; 640] = [0; 640];

    let mut board = Board::new(PIXELS);
    let display = &mut board.display;
    match BUFFER.decode(SCENE) {
        Ok(scene) => {
            let mut renderer = Renderer::new(&scene, display.size());
            // In coarse blocks first.
            let mut drawing = RenderProgress::progressive(display.bounding_box());
            while !drawing.is_complete() {
                match renderer.step(&mut drawing, Step::Line, display) {
                    Ok(()) => board.watchdog.feed(),
                    // The drawing is where it was: this line is sent again, or
                    // the watchdog starts over.
                    Err(error) => error!("the display fails: {}", error),
                }
            }
            info!("the picture is complete");
        }
        Err(error) => {
            error!("the scene in flash: {}", Display2Format(&error));
            let text = format_args!("The scene in flash cannot be drawn: {error}.");
            _ = message_page::write(display, &FONT_10X20, text);
        }
    }
    board.rest()
}
