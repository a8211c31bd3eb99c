//! Defines the board: clock, display and pins. To use another board or display, change this file.
//!
//! The values are for the "black pill" with an STM32F411CE and an ST7789 panel of 240x240 pixels.

use embedded_graphics::prelude::*;
use embedded_hal::spi::{MODE_3, Mode};
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::interface::SpiInterface;
/// Controller of the display, for example `GC9A01`, `ILI9341Rgb565`, `ST7735s` or `ST7789`.
use mipidsi::models::ST7789 as Controller;
use mipidsi::options::{ColorInversion, ColorOrder, Orientation};
use stm32f4xx_hal::gpio::{Output, PC13, PinState, Speed};
use stm32f4xx_hal::pac::{CorePeripherals, Peripherals, SPI1};
use stm32f4xx_hal::prelude::*;
use stm32f4xx_hal::rcc::Config;
use stm32f4xx_hal::spi::Spi;
use stm32f4xx_hal::watchdog::IndependentWatchdog;

/// Frequency of the crystal, in MHz.
const CRYSTAL: u32 = 25;
/// Frequency of the core, in MHz. The limit of the chip is 100 MHz.
const CORE: u32 = 100;
/// The SPI clock is `CORE` divided by this power of two: 25 MHz. With long wires, use 8 or 16.
const SPI_DIVIDER: u32 = 4;
/// Polarity and phase of the SPI clock. Modules without a CS pin need `MODE_3`.
const SPI_MODE: Mode = MODE_3;

/// Width and height of the panel in pixels, before it is rotated.
const SIZE: (u16, u16) = (240, 240);
/// Column and row of the controller's memory at which the panel begins, before it is rotated.
const OFFSET: (u16, u16) = (0, 0);
/// Rotation and mirroring, for example `Orientation::new().rotate(Rotation::Deg90)` or
/// `Orientation::new().flip_horizontal()`.
const ORIENTATION: Orientation = Orientation::new();
/// `Inverted` for IPS panels, `Normal` for most others.
const INVERSION: ColorInversion = ColorInversion::Inverted;
/// Order of the color filters on the panel. `Bgr` swaps red and blue.
const COLOR_ORDER: ColorOrder = ColorOrder::Rgb;
/// Level of the backlight pin that turns the light on.
const BACKLIGHT_ON: PinState = PinState::High;

/// Time in milliseconds after which the watchdog resets the chip if it is not fed.
const WATCHDOG_TIMEOUT: u32 = 4000;

const _: () = {
    let (width, height) = <Controller as mipidsi::models::Model>::FRAMEBUFFER_SIZE;
    assert!(
        SIZE.0 + OFFSET.0 <= width && SIZE.1 + OFFSET.1 <= height,
        "SIZE and OFFSET exceed the memory of the display controller"
    );
};

/// Color format of the display.
pub(crate) type Color = <Controller as mipidsi::models::Model>::ColorFormat;

/// Initialized hardware of the board.
pub(crate) struct Board<D> {
    pub(crate) display: D,
    pub(crate) watchdog: IndependentWatchdog,
    /// Blue LED of the black pill. The level `low` turns it on.
    pub(crate) led: PC13<Output>,
}

/// Initializes the board. The display driver uses `line` as its transfer buffer.
///
/// This function must be called only once.
pub(crate) fn init(
    line: &'static mut [u8],
) -> Board<impl DrawTarget<Color = Color, Error: defmt::Format> + OriginDimensions> {
    let (Some(chip), Some(core)) = (Peripherals::take(), CorePeripherals::take()) else {
        defmt::panic!("the board is already initialized");
    };
    let clock = Config::hse(CRYSTAL.MHz()).sysclk(CORE.MHz());
    let mut rcc = chip.RCC.freeze(clock);
    let mut delay = core.SYST.delay(&rcc.clocks);

    // Pins that the display is wired to. Only the pins PA5 and PB3 can be the clock of SPI 1, and
    // only PA7 and PB5 its data output.
    let a = chip.GPIOA.split(&mut rcc);
    let b = chip.GPIOB.split(&mut rcc);
    let c = chip.GPIOC.split(&mut rcc);
    let clock = a.pa5.into_alternate().speed(Speed::High);
    let data = a.pa7.into_alternate().speed(Speed::High);
    let select = a.pa4.into_push_pull_output_in_state(PinState::High);
    let data_or_command = b.pb0.into_push_pull_output();
    let reset = b.pb1.into_push_pull_output_in_state(PinState::High);
    let mut backlight = b.pb10.into_push_pull_output_in_state(!BACKLIGHT_ON);
    let led = c.pc13.into_push_pull_output_in_state(PinState::High);

    let frequency = rcc.clocks.pclk2() / SPI_DIVIDER;
    let pins = (Some(clock), SPI1::NoMiso, Some(data));
    let spi = Spi::new(chip.SPI1, pins, SPI_MODE, frequency, &mut rcc);
    let Ok(device) = ExclusiveDevice::new_no_delay(spi, select);
    let interface = SpiInterface::new(device, data_or_command, line);
    let display = mipidsi::Builder::new(Controller, interface)
        .reset_pin(reset)
        .display_size(SIZE.0, SIZE.1)
        .display_offset(OFFSET.0, OFFSET.1)
        .orientation(ORIENTATION)
        .invert_colors(INVERSION)
        .color_order(COLOR_ORDER)
        .init(&mut delay);
    let mut display = match display {
        Ok(display) => display,
        Err(error) => defmt::panic!("display initialization failed: {}", error),
    };
    // The memory of the display is undefined after power-on, so it is cleared before the backlight
    // turns on. If this fails, drawing fails too and reports the error.
    _ = display.clear(Color::BLACK);
    backlight.set_state(BACKLIGHT_ON);

    let mut watchdog = IndependentWatchdog::new(chip.IWDG);
    watchdog.start(WATCHDOG_TIMEOUT.millis());
    Board {
        display,
        watchdog,
        led,
    }
}
