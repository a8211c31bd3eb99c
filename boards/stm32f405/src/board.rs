//! What differs from board to board: the crystal, and the wiring of the display.
//! This is for the Feather STM32F405.

use embedded_hal::spi::MODE_0;
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use mipidsi::interface::SpiInterface;
use mipidsi::models::ILI9341Rgb565;
use mipidsi::options::{ColorOrder, Orientation, Rotation};
use stm32f4xx_hal::gpio::{Output, PA4, PB8, PB9, Speed};
use stm32f4xx_hal::pac::{CorePeripherals, Peripherals, SPI1};
use stm32f4xx_hal::prelude::*;
use stm32f4xx_hal::rcc::Config;
use stm32f4xx_hal::spi::Spi;
use stm32f4xx_hal::watchdog::IndependentWatchdog;

type Select = PB8<Output>;
type DataOrCommand = PA4<Output>;
type Reset = PB9<Output>;

type Device = ExclusiveDevice<Spi<SPI1>, Select, NoDelay>;
type Display = mipidsi::Display<SpiInterface<'static, Device, DataOrCommand>, ILI9341Rgb565, Reset>;

/// What the firmware uses of the board.
pub(crate) struct Board {
    pub(crate) display: Display,
    pub(crate) watchdog: IndependentWatchdog,
}

impl Board {
    /// Sets the board up, with room for pixels on their way to the display; to be
    /// called once.
    pub(crate) fn new(pixels: &'static mut [u8]) -> Self {
        let (Some(chip), Some(core)) = (Peripherals::take(), CorePeripherals::take()) else {
            defmt::panic!("the board is set up twice");
        };
        let mut rcc = chip.RCC.freeze(clock());
        let mut delay = core.SYST.delay(&rcc.clocks);
        let port_a = chip.GPIOA.split(&mut rcc);
        let port_b = chip.GPIOB.split(&mut rcc);

        let clock = port_a.pa5.into_alternate().speed(Speed::High);
        let output = port_a.pa7.into_alternate().speed(Speed::High);
        let pins = (Some(clock), SPI1::NoMiso, Some(output));
        // 21 MHz.
        let frequency = rcc.clocks.pclk2() / 4;
        let spi = Spi::new(chip.SPI1, pins, MODE_0, frequency, &mut rcc);

        let select: Select = port_b.pb8.into_push_pull_output();
        let data_or_command: DataOrCommand = port_a.pa4.into_push_pull_output();
        let reset: Reset = port_b.pb9.into_push_pull_output();
        let Ok(device) = ExclusiveDevice::new_no_delay(spi, select);

        let landscape = Orientation::new().rotate(Rotation::Deg90).flip_vertical();
        let interface = SpiInterface::new(device, data_or_command, pixels);
        let display = mipidsi::Builder::new(ILI9341Rgb565, interface)
            .color_order(ColorOrder::Bgr)
            .orientation(landscape)
            .reset_pin(reset)
            .init(&mut delay);
        let display = match display {
            Ok(display) => display,
            Err(error) => defmt::panic!("the display does not start: {}", error),
        };

        let mut watchdog = IndependentWatchdog::new(chip.IWDG);
        // A line takes some milliseconds.
        watchdog.start(4.secs());
        Self { display, watchdog }
    }

    /// Leaves the picture on the display.
    pub(crate) fn rest(mut self) -> ! {
        #[cfg(feature = "emulator")]
        cortex_m_semihosting::debug::exit(cortex_m_semihosting::debug::EXIT_SUCCESS);
        loop {
            self.watchdog.feed();
        }
    }
}

/// 168 MHz, from the crystal of 12 MHz.
#[cfg(not(feature = "emulator"))]
fn clock() -> Config {
    Config::hse(12.MHz()).sysclk(168.MHz())
}

/// The internal oscillator: emulators have no crystal.
#[cfg(feature = "emulator")]
fn clock() -> Config {
    Config::hsi()
}
