//! Hardware setup for the nRF52840-DK with an ILI9341 shield: wiring and display.

use embassy_nrf::gpio::{Level, Output, OutputDrive};
use embassy_nrf::spim::{self, Spim};
use embassy_nrf::wdt::{self, Watchdog, WatchdogHandle};
use embassy_nrf::{bind_interrupts, peripherals};
use embassy_time::Delay;
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use mipidsi::options::{ColorOrder, Orientation, Rotation};
use mipidsi::{Builder, interface::SpiInterface, models::ILI9341Rgb565};

/// SPI device that the display is connected to. It sends data by DMA. The caller can wait
/// for a transfer in blocking or async code.
type Device = ExclusiveDevice<Spim<'static>, Output<'static>, NoDelay>;

/// The display with its blocking driver.
pub(crate) type Display<'l> =
    mipidsi::Display<SpiInterface<'l, Device, Output<'static>>, ILI9341Rgb565, Output<'static>>;

bind_interrupts!(struct Interrupts {
    SPIM3 => spim::InterruptHandler<peripherals::SPI3>;
});

/// The initialized display and watchdog of the board.
pub(crate) struct Board<'l> {
    pub(crate) display: Display<'l>,
    /// Watchdog timer. It resets the chip if the firmware does not feed it for four
    /// seconds.
    pub(crate) watchdog: WatchdogHandle,
}

/// Initializes the board. The display driver uses `line` as its transfer buffer.
///
/// This function must be called only once.
pub(crate) fn init(line: &mut [u8]) -> Board<'_> {
    let chip = embassy_nrf::init(embassy_nrf::config::Config::default());

    // The display is wired to the header pins D8 to D11 and D13 of the nRF52840-DK. Arduino
    // display shields use the same pins.
    let drive = OutputDrive::Standard;
    let reset = Output::new(chip.P1_10, Level::High, drive);
    let data_or_command = Output::new(chip.P1_11, Level::Low, drive);
    let select = Output::new(chip.P1_12, Level::High, drive);
    let mut config = spim::Config::default();
    config.frequency = spim::Frequency::M16;
    let spi = Spim::new_txonly(chip.SPI3, Interrupts, chip.P1_15, chip.P1_13, config);

    let Ok(device) = ExclusiveDevice::new_no_delay(spi, select);
    let interface = SpiInterface::new(device, data_or_command, line);
    let Ok(display) = Builder::new(ILI9341Rgb565, interface)
        .reset_pin(reset)
        .color_order(ColorOrder::Bgr)
        .orientation(Orientation::new().rotate(Rotation::Deg90).flip_vertical())
        .init(&mut Delay)
    else {
        defmt::panic!("display initialization failed");
    };

    let mut config = wdt::Config::default();
    config.timeout_ticks = 4 * 32_768;
    let Ok((_, [watchdog])) = Watchdog::try_new(chip.WDT, config) else {
        defmt::panic!("the watchdog is already running with another configuration");
    };
    Board { display, watchdog }
}
