//! Draws a scene on the OLED of the LM3S6965 evaluation board.
//!
//! The scene is compiled on the host and lies in flash; see `build.rs`.

#![no_std]
#![no_main]

mod board;
mod gpio;
mod panic;
mod pl022;
mod register;
mod ssd0323;
mod uart;

use core::fmt::Write;

use cortex_m_rt::entry;
use embedded_graphics::{mono_font::ascii::FONT_5X8, prelude::OriginDimensions};
use whitted::{Renderer, SceneBuffer};

use board::Board;

/// The scene, compiled.
static SCENE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/scene.bin"));
const COUNTS: [usize; 3] = whitted::counts(SCENE);

#[entry]
fn main() -> ! {
    // Room for the scene, and the display driver's copy of its pixels.
    static mut BUFFER: SceneBuffer<{ COUNTS[0] }, { COUNTS[1] }, { COUNTS[2] }> =
        SceneBuffer::new();
    static mut PIXELS: ssd0323::Pixels = ssd0323::BLACK;

    let Board {
        mut oled,
        mut uart,
        mut stopwatch,
    } = Board::new(PIXELS);

    // The UART cannot fail, so what `write!` returns says nothing.
    _ = match BUFFER.decode(SCENE) {
        Ok(scene) => {
            let mut renderer = Renderer::new(&scene, oled.size());
            let Ok(report) = measure::draw(&mut renderer, &mut oled, &mut stopwatch);
            writeln!(
                uart,
                "{report}framebuffer: {}",
                size_of::<ssd0323::Pixels>()
            )
        }
        Err(error) => {
            let text = format_args!("The scene in flash cannot be drawn: {error}.");
            _ = page::write(&mut oled, &FONT_5X8, text);
            writeln!(uart, "error: {error}")
        }
    };
    _ = writeln!(uart, "{}", measure::END);

    // The picture stays on the display.
    loop {
        cortex_m::asm::wfi();
    }
}
