//! Hardware setup for the Feather STM32F405: clock, wiring and display.
//!
//! For another board with this chip, change the crystal frequency and the pins in this
//! file.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_hal::spi::MODE_0;
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ILI9341Rgb565;
use mipidsi::options::{ColorOrder, Orientation, Rotation};
use stm32f4xx_hal::gpio::Speed;
use stm32f4xx_hal::pac::{CorePeripherals, Peripherals, SPI1};
use stm32f4xx_hal::prelude::*;
use stm32f4xx_hal::rcc::Config;
use stm32f4xx_hal::spi::Spi;
use stm32f4xx_hal::watchdog::IndependentWatchdog;

/// The initialized display and watchdog of the board.
pub(crate) struct Board<D> {
    pub(crate) display: D,
    /// Watchdog timer. It resets the chip if the firmware does not feed it for four
    /// seconds.
    pub(crate) watchdog: IndependentWatchdog,
}

/// Initializes the board. The display driver uses `line` as its transfer buffer.
///
/// This function must be called only once.
pub(crate) fn init(
    line: &'static mut [u8],
) -> Board<impl DrawTarget<Color = Rgb565, Error: defmt::Format> + OriginDimensions> {
    let (Some(chip), Some(core)) = (Peripherals::take(), CorePeripherals::take()) else {
        defmt::panic!("the board is already initialized");
    };
    let mut rcc = chip.RCC.freeze(clock());
    let mut delay = core.SYST.delay(&rcc.clocks);

    // Pins that the display is wired to.
    let port_a = chip.GPIOA.split(&mut rcc);
    let port_b = chip.GPIOB.split(&mut rcc);
    let clock = port_a.pa5.into_alternate().speed(Speed::High);
    let output = port_a.pa7.into_alternate().speed(Speed::High);
    let data_or_command = port_a.pa4.into_push_pull_output();
    let select = port_b.pb8.into_push_pull_output();
    let reset = port_b.pb9.into_push_pull_output();

    // The SPI clock is 84 MHz / 4 = 21 MHz.
    let frequency = rcc.clocks.pclk2() / 4;
    let pins = (Some(clock), SPI1::NoMiso, Some(output));
    let spi = Spi::new(chip.SPI1, pins, MODE_0, frequency, &mut rcc);
    let Ok(device) = ExclusiveDevice::new_no_delay(spi, select);

    let display = mipidsi::Builder::new(
        ILI9341Rgb565,
        SpiInterface::new(device, data_or_command, line),
    )
    .color_order(ColorOrder::Bgr)
    .orientation(Orientation::new().rotate(Rotation::Deg90).flip_vertical())
    .reset_pin(reset)
    .init(&mut delay);
    let display = match display {
        Ok(display) => display,
        Err(error) => defmt::panic!("display initialization failed: {}", error),
    };

    // Drawing a line takes a few milliseconds, much less than the watchdog timeout of four
    // seconds.
    let mut watchdog = IndependentWatchdog::new(chip.IWDG);
    watchdog.start(4.secs());
    Board { display, watchdog }
}

/// Feeds the watchdog forever. The watchdog therefore never resets the chip, and the
/// picture stays on the display.
///
/// With the feature `emulator`, this function exits the emulator instead.
pub(crate) fn finish(mut watchdog: IndependentWatchdog) -> ! {
    #[cfg(feature = "emulator")]
    cortex_m_semihosting::debug::exit(cortex_m_semihosting::debug::EXIT_SUCCESS);
    loop {
        watchdog.feed();
    }
}

/// Returns the clock configuration of the chip. The core clock of 168 MHz is derived from
/// the 12 MHz crystal.
#[cfg(not(feature = "emulator"))]
fn clock() -> Config {
    Config::hse(12.MHz()).sysclk(168.MHz())
}

/// Returns the clock configuration for QEMU, which has no crystal. The core clock is the
/// internal oscillator.
#[cfg(feature = "emulator")]
fn clock() -> Config {
    Config::hsi()
}
