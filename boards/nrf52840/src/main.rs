//! Draws a scene on an ILI9341 display of 320x240 pixels, at an nRF52840: each line
//! is traced while DMA sends the one before.
//!
//! The scene is compiled on the host and lies in flash; see `build.rs`.

#![no_std]
#![no_main]

use core::mem::swap;

use defmt::{Display2Format, error, info};
use embassy_executor::Spawner;
use embassy_futures::join::join;
use embassy_nrf::gpio::{Level, Output, OutputDrive};
use embassy_nrf::spim::{self, Spim};
use embassy_nrf::wdt::{self, Watchdog};
use embassy_nrf::{bind_interrupts, peripherals};
use embassy_time::Delay;
use embedded_graphics::mono_font::ascii::FONT_10X20;
use embedded_graphics::pixelcolor::{Rgb565, raw::ToBytes};
use embedded_graphics::prelude::*;
use embedded_hal_async::spi::SpiDevice;
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::options::{ColorOrder, Orientation, Rotation};
use mipidsi::{Builder, interface::SpiInterface, models::ILI9341Rgb565};
use whitted::Renderer;
use whitted::render::{RenderProgress, Step};
use whitted::scene::SceneCounts;
use {defmt_rtt as _, panic_probe as _};

/// The scene, compiled.
static SCENE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/scene.bin"));
const COUNTS: SceneCounts = SceneCounts::of_compiled(SCENE);

const WIDTH: usize = 320;
const HEIGHT: u32 = 240;

/// A line as it goes over the wire.
type Bytes = [u8; 2 * WIDTH];

bind_interrupts!(struct Interrupts {
    SPIM3 => spim::InterruptHandler<peripherals::SPI3>;
});

#[embassy_executor::main]
async fn main(_spawner: Spawner) {
    let chip = embassy_nrf::init(embassy_nrf::config::Config::default());

    // The wiring: D8 to D11 and D13 of the nRF52840-DK, where shields have it.
    let drive = OutputDrive::Standard;
    let reset = Output::new(chip.P1_10, Level::High, drive);
    let data_or_command = Output::new(chip.P1_11, Level::Low, drive);
    let select = Output::new(chip.P1_12, Level::High, drive);
    let mut mode = spim::Config::default();
    mode.frequency = spim::Frequency::M16;
    let spi = Spim::new_txonly(chip.SPI3, Interrupts, chip.P1_15, chip.P1_13, mode);

    let Ok(device) = ExclusiveDevice::new_no_delay(spi, select);
    let mut bytes: Bytes = [0; 2 * WIDTH];
    let interface = SpiInterface::new(device, data_or_command, &mut bytes);
    let Ok(mut display) = Builder::new(ILI9341Rgb565, interface)
        .reset_pin(reset)
        .color_order(ColorOrder::Bgr)
        .orientation(Orientation::new().rotate(Rotation::Deg90).flip_vertical())
        .init(&mut Delay)
    else {
        defmt::panic!("the display does not start");
    };

    let mut config = wdt::Config::default();
    config.timeout_ticks = 4 * 32_768;
    let Ok((_, [mut watchdog])) = Watchdog::try_new(chip.WDT, config) else {
        defmt::panic!("the watchdog runs with other settings");
    };

    let mut buffer = <whitted::scene_buffer!(COUNTS)>::new();
    let scene = match buffer.decode(SCENE) {
        Ok(scene) => scene,
        Err(error) => {
            error!("the scene in flash: {}", Display2Format(&error));
            let text = format_args!("The scene in flash cannot be drawn: {error}.");
            _ = message_page::write(&mut display, &FONT_10X20, text);
            loop {
                watchdog.pet();
            }
        }
    };
    let mut renderer = Renderer::new(&scene, display.size());

    // First all of it in coarse blocks, which is 1/256 of the work.
    let mut drawing = RenderProgress::progressive(display.bounding_box());
    let coarse = renderer.step(&mut drawing, Step::Pass, &mut display);
    // Then the lines, by DMA: what is sent now goes to the whole window.
    let last = (WIDTH as u16 - 1, HEIGHT as u16 - 1);
    let window = display.set_pixels(0, 0, last.0, last.1, core::iter::empty());
    if coarse.is_err() || window.is_err() {
        defmt::panic!("the display fails");
    }
    let (interface, _, _reset) = display.release();
    let (mut device, _data_or_command) = interface.release();

    let (mut sent, mut traced): (Bytes, Bytes) = ([0; 2 * WIDTH], [0; 2 * WIDTH]);
    trace(&mut renderer, 0, &mut traced);
    for below in 1..=HEIGHT {
        swap(&mut sent, &mut traced);
        // The first is polled first, and starts the DMA; while that runs, the
        // second traces. The line below the last is empty.
        let send = device.write(&sent);
        let (outcome, ()) = join(send, async { trace(&mut renderer, below, &mut traced) }).await;
        if outcome.is_err() {
            defmt::panic!("the display fails");
        }
        watchdog.pet();
    }
    info!("the picture is complete");
    loop {
        watchdog.pet();
    }
}

/// Traces line `y` as the display wants its bytes.
fn trace(renderer: &mut Renderer<'_>, y: u32, bytes: &mut Bytes) {
    let mut line = [Rgb565::BLACK; WIDTH];
    renderer.render_line(y, &mut line);
    let (pairs, _) = bytes.as_chunks_mut();
    for (pair, color) in pairs.iter_mut().zip(line) {
        *pair = color.to_be_bytes();
    }
}
