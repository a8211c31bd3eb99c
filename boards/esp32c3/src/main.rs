//! Draws a scene on an ST7789 display of 320x240 pixels, at an ESP32-C3.
//!
//! The scene is compiled on the host and lies in flash; see `build.rs`.

#![no_std]
#![no_main]

use embedded_graphics::{mono_font::ascii::FONT_10X20, prelude::*};
use embedded_hal_bus::spi::ExclusiveDevice;
use esp_backtrace as _;
use esp_hal::clock::CpuClock;
use esp_hal::delay::Delay;
use esp_hal::gpio::{Level, Output, OutputConfig};
use esp_hal::spi::master::{Config, Spi};
use esp_hal::time::{Duration, Rate};
use esp_hal::timer::timg::{MwdtStage, TimerGroup};
use esp_println::println;
use mipidsi::options::{ColorInversion, Orientation, Rotation};
use mipidsi::{Builder, interface::SpiInterface, models::ST7789};
use whitted::Renderer;
use whitted::render::{RenderProgress, Step};
use whitted::scene::SceneCounts;

/// The scene, compiled.
static SCENE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/scene.bin"));
const COUNTS: SceneCounts = SceneCounts::of_compiled(SCENE);

// What the second bootloader wants to know.
esp_bootloader_esp_idf::esp_app_desc!();

#[esp_hal::main]
fn main() -> ! {
    let chip = esp_hal::init(esp_hal::Config::default().with_cpu_clock(CpuClock::max()));

    // The wiring.
    let clock = chip.GPIO6;
    let output = chip.GPIO7;
    let low = OutputConfig::default();
    let select = Output::new(chip.GPIO10, Level::High, low);
    let data_or_command = Output::new(chip.GPIO4, Level::Low, low);
    let reset = Output::new(chip.GPIO5, Level::High, low);

    let mode = Config::default().with_frequency(Rate::from_mhz(40));
    let Ok(spi) = Spi::new(chip.SPI2, mode) else {
        panic!("the SPI has no such frequency");
    };
    let Ok(device) = ExclusiveDevice::new_no_delay(spi.with_sck(clock).with_mosi(output), select);
    // Pixels on their way to the display.
    let mut pixels = [0; 640];
    let interface = SpiInterface::new(device, data_or_command, &mut pixels);
    let Ok(mut display) = Builder::new(ST7789, interface)
        .reset_pin(reset)
        .invert_colors(ColorInversion::Inverted)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut Delay::new())
    else {
        panic!("the display does not start");
    };

    let mut watchdog = TimerGroup::new(chip.TIMG0).wdt;
    watchdog.set_timeout(MwdtStage::Stage0, Duration::from_secs(4));
    watchdog.enable();

    let mut buffer = <whitted::scene_buffer!(COUNTS)>::new();
    match buffer.decode(SCENE) {
        Ok(scene) => {
            let mut renderer = Renderer::new(&scene, display.size());
            // In coarse blocks first.
            let mut drawing = RenderProgress::progressive(display.bounding_box());
            while !drawing.is_complete() {
                match renderer.step(&mut drawing, Step::Line, &mut display) {
                    Ok(()) => watchdog.feed(),
                    // The drawing is where it was: this line is sent again, or
                    // the watchdog starts over.
                    Err(error) => println!("the display fails: {error:?}"),
                }
            }
            println!("the picture is complete");
        }
        Err(error) => {
            println!("the scene in flash: {error}");
            let text = format_args!("The scene in flash cannot be drawn: {error}.");
            _ = message_page::write(&mut display, &FONT_10X20, text);
        }
    }

    loop {
        watchdog.feed();
    }
}
