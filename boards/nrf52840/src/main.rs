//! Draws a scene on an ILI9341 display of 320x240 pixels, on an nRF52840.
//!
//! The firmware traces each line while DMA sends the previous line. The build script
//! compiles the scene file on the host. The firmware contains the compiled scene.
//! `board.rs` initializes the hardware.

#![no_std]
#![no_main]

mod board;

use core::mem::swap;

use defmt::{Display2Format, error, info};
use embassy_executor::Spawner;
use embassy_futures::join::join;
use embassy_nrf::wdt::WatchdogHandle;
use embedded_graphics::mono_font::ascii::FONT_10X20;
use embedded_graphics::pixelcolor::{Rgb565, raw::ToBytes};
use embedded_graphics::prelude::*;
use embedded_hal_async::spi::SpiDevice;
use whitted::Renderer;
use whitted::render::{RenderProgress, Step};
use whitted::scene::SceneCounts;
use {defmt_rtt as _, panic_probe as _};

use board::{Board, Display};

/// The compiled scene in flash.
static SCENE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/scene.bin"));

/// Number of objects, lights and materials in the scene.
const COUNTS: SceneCounts = SceneCounts::of_compiled(SCENE);

const WIDTH: u16 = 320;
const HEIGHT: u16 = 240;

/// A line of RGB565 pixels, in the byte order of the display.
type LineBytes = [u8; 2 * WIDTH as usize];
const BLACK_LINE: LineBytes = [0; size_of::<LineBytes>()];

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let mut buffer = <whitted::scene_buffer!(COUNTS)>::new();
    let mut line = BLACK_LINE;

    let Board {
        mut display,
        mut watchdog,
    } = board::init(&mut line);

    match buffer.decode(SCENE) {
        Ok(scene) => {
            let mut renderer = Renderer::new(&scene, display.size());
            draw_preview(&mut renderer, &mut display);
            draw_lines(&mut renderer, display, &mut watchdog).await;
            info!("picture complete");
        }
        Err(error) => {
            error!("invalid scene in flash: {}", Display2Format(&error));
            let text = format_args!("The scene in flash cannot be drawn: {error}.");
            _ = message_page::write(&mut display, &FONT_10X20, text);
        }
    }
    loop {
        watchdog.pet();
    }
}

/// Draws a preview in blocks of 16x16 pixels, which is the first pass of progressive order.
/// The preview takes 1/256 of the work of the whole picture.
fn draw_preview(renderer: &mut Renderer<'_>, display: &mut Display<'_>) {
    let mut progress = RenderProgress::progressive(display.bounding_box());
    if renderer.step(&mut progress, Step::Pass, display).is_err() {
        defmt::panic!("display error");
    }
}

/// Draws all lines from top to bottom and sends them by DMA.
async fn draw_lines(
    renderer: &mut Renderer<'_>,
    mut display: Display<'_>,
    watchdog: &mut WatchdogHandle,
) {
    // Select the whole display as the window and start a pixel transfer. After that, this
    // function sends all lines directly to the SPI device, without the blocking driver.
    let window = display.set_pixels(0, 0, WIDTH - 1, HEIGHT - 1, core::iter::empty());
    if window.is_err() {
        defmt::panic!("display error");
    }
    // The variables `_reset` and `_data_or_command` own the reset and D/C pins. The two
    // pins therefore hold their levels until the end of this function.
    let (interface, _, _reset) = display.release();
    let (mut device, _data_or_command) = interface.release();

    let (mut sent, mut traced) = (BLACK_LINE, BLACK_LINE);
    trace_line(renderer, 0, &mut traced);
    for next in 1..=u32::from(HEIGHT) {
        swap(&mut sent, &mut traced);
        // `join` polls `write` first, which starts the DMA transfer. While the transfer
        // runs, `join` traces the next line. In the last iteration, `next` is below the
        // display, so the traced line is black and is never sent.
        let trace = async { trace_line(renderer, next, &mut traced) };
        let (result, ()) = join(device.write(&sent), trace).await;
        if result.is_err() {
            defmt::panic!("display error");
        }
        watchdog.pet();
    }
}

/// Traces line `y` and encodes it for the display.
fn trace_line(renderer: &mut Renderer<'_>, y: u32, bytes: &mut LineBytes) {
    let mut line = [Rgb565::BLACK; WIDTH as usize];
    renderer.render_line(y, &mut line);
    let (pairs, _) = bytes.as_chunks_mut();
    for (pair, color) in pairs.iter_mut().zip(line) {
        *pair = color.to_be_bytes();
    }
}
