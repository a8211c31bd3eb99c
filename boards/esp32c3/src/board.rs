//! Hardware setup for the ESP32-C3: clock, wiring and display.

use core::fmt::Debug;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_hal_bus::spi::ExclusiveDevice;
use esp_hal::clock::CpuClock;
use esp_hal::delay::Delay;
use esp_hal::gpio::{Level, Output, OutputConfig};
use esp_hal::peripherals::TIMG0;
use esp_hal::spi::master::{Config, Spi};
use esp_hal::time::{Duration, Rate};
use esp_hal::timer::timg::{MwdtStage, TimerGroup, Wdt};
use mipidsi::options::{ColorInversion, Orientation, Rotation};
use mipidsi::{Builder, interface::SpiInterface, models::ST7789};

// The second-stage bootloader requires that the program contains this application
// descriptor.
esp_bootloader_esp_idf::esp_app_desc!();

/// The initialized display and watchdog of the board.
pub(crate) struct Board<D> {
    pub(crate) display: D,
    /// Watchdog timer. It resets the chip if the firmware does not feed it for four
    /// seconds.
    pub(crate) watchdog: Wdt<TIMG0<'static>>,
}

/// Initializes the board. The display driver uses `line` as its transfer buffer.
///
/// This function must be called only once.
pub(crate) fn init(
    line: &mut [u8],
) -> Board<impl DrawTarget<Color = Rgb565, Error: Debug> + OriginDimensions> {
    let chip = esp_hal::init(esp_hal::Config::default().with_cpu_clock(CpuClock::max()));

    // Pins that the display is wired to.
    let clock = chip.GPIO6;
    let output = chip.GPIO7;
    let select = Output::new(chip.GPIO10, Level::High, OutputConfig::default());
    let data_or_command = Output::new(chip.GPIO4, Level::Low, OutputConfig::default());
    let reset = Output::new(chip.GPIO5, Level::High, OutputConfig::default());

    let config = Config::default().with_frequency(Rate::from_mhz(40));
    let Ok(spi) = Spi::new(chip.SPI2, config) else {
        panic!("invalid SPI frequency");
    };
    let Ok(device) = ExclusiveDevice::new_no_delay(spi.with_sck(clock).with_mosi(output), select);
    let interface = SpiInterface::new(device, data_or_command, line);
    let Ok(display) = Builder::new(ST7789, interface)
        .reset_pin(reset)
        .invert_colors(ColorInversion::Inverted)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut Delay::new())
    else {
        panic!("display initialization failed");
    };

    let mut watchdog = TimerGroup::new(chip.TIMG0).wdt;
    watchdog.set_timeout(MwdtStage::Stage0, Duration::from_secs(4));
    watchdog.enable();
    Board { display, watchdog }
}
