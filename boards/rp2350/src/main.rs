//! Draws a scene on an ST7789 display of 320x240 pixels, at a Raspberry Pi Pico 2.
//!
//! The scene is compiled on the host and lies in flash; see `build.rs`.

#![no_std]
#![no_main]

use defmt::{Display2Format, error, info, unwrap};
use embedded_graphics::{mono_font::ascii::FONT_10X20, prelude::*};
use embedded_hal::{digital::OutputPin, spi::MODE_0};
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::options::{ColorInversion, Orientation, Rotation};
use mipidsi::{Builder, interface::SpiInterface, models::ST7789};
use rp235x_hal::block::ImageDef;
use rp235x_hal::clocks::init_clocks_and_plls;
use rp235x_hal::fugit::{ExtU32, RateExtU32};
use rp235x_hal::gpio::{FunctionSpi, Pins};
use rp235x_hal::{self as hal, Clock, Sio, Spi, Timer, Watchdog, pac};
use whitted::Renderer;
use whitted::render::{RenderProgress, Step};
use whitted::scene::SceneCounts;
use {defmt_rtt as _, panic_probe as _};

/// The scene, compiled.
static SCENE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/scene.bin"));
const COUNTS: SceneCounts = SceneCounts::of_compiled(SCENE);

/// Tells the boot ROM that this is a program.
#[unsafe(link_section = ".start_block")]
#[used]
static IMAGE_DEF: ImageDef = ImageDef::secure_exe();

/// The crystal, in Hz.
const CRYSTAL: u32 = 12_000_000;

#[hal::entry]
fn main() -> ! {
    // Room for the scene, and for pixels on their way to the display.
    static mut BUFFER: whitted::scene_buffer!(COUNTS) = <whitted::scene_buffer!(COUNTS)>::new();
    static mut PIXELS: [u8; 640] = [0; 640];

    let mut chip = unwrap!(pac::Peripherals::take());
    let mut watchdog = Watchdog::new(chip.WATCHDOG);
    let Ok(clocks) = init_clocks_and_plls(
        CRYSTAL,
        chip.XOSC,
        chip.CLOCKS,
        chip.PLL_SYS,
        chip.PLL_USB,
        &mut chip.RESETS,
        &mut watchdog,
    ) else {
        defmt::panic!("the crystal does not start");
    };
    let mut delay = Timer::new_timer0(chip.TIMER0, &mut chip.RESETS, &clocks);

    // The wiring of the usual Pico LCD hats.
    let sio = Sio::new(chip.SIO);
    let pins = Pins::new(
        chip.IO_BANK0,
        chip.PADS_BANK0,
        sio.gpio_bank0,
        &mut chip.RESETS,
    );
    let data_or_command = pins.gpio8.into_push_pull_output();
    let select = pins.gpio9.into_push_pull_output();
    let clock = pins.gpio10.into_function::<FunctionSpi>();
    let output = pins.gpio11.into_function::<FunctionSpi>();
    let reset = pins.gpio12.into_push_pull_output();
    let mut backlight = pins.gpio13.into_push_pull_output();

    let spi = Spi::<_, _, _, 8>::new(chip.SPI1, (output, clock)).init(
        &mut chip.RESETS,
        clocks.peripheral_clock.freq(),
        62_500.kHz(),
        MODE_0,
    );
    let Ok(device) = ExclusiveDevice::new_no_delay(spi, select);
    let interface = SpiInterface::new(device, data_or_command, PIXELS);
    let Ok(mut display) = Builder::new(ST7789, interface)
        .reset_pin(reset)
        .invert_colors(ColorInversion::Inverted)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut delay)
    else {
        defmt::panic!("the display does not start");
    };
    let Ok(()) = backlight.set_high();
    watchdog.start(4.secs());

    match BUFFER.decode(SCENE) {
        Ok(scene) => {
            let mut renderer = Renderer::new(&scene, display.size());
            // In coarse blocks first.
            let mut drawing = RenderProgress::progressive(display.bounding_box());
            while !drawing.is_complete() {
                match renderer.step(&mut drawing, Step::Line, &mut display) {
                    Ok(()) => watchdog.feed(),
                    // The drawing is where it was: this line is sent again, or
                    // the watchdog starts over.
                    Err(_) => error!("the display fails"),
                }
            }
            info!("the picture is complete");
        }
        Err(error) => {
            error!("the scene in flash: {}", Display2Format(&error));
            let text = format_args!("The scene in flash cannot be drawn: {error}.");
            _ = message_page::write(&mut display, &FONT_10X20, text);
        }
    }

    loop {
        watchdog.feed();
    }
}
