//! Hardware setup for the Raspberry Pi Pico 2 with a Pico LCD hat: clocks, wiring and
//! display.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_hal::{digital::OutputPin, spi::MODE_0};
use embedded_hal_bus::spi::ExclusiveDevice;
use mipidsi::options::{ColorInversion, Orientation, Rotation};
use mipidsi::{Builder, interface::SpiInterface, models::ST7789};
use rp235x_hal::block::ImageDef;
use rp235x_hal::clocks::init_clocks_and_plls;
use rp235x_hal::fugit::{ExtU32, RateExtU32};
use rp235x_hal::gpio::{FunctionSpi, Pins};
use rp235x_hal::{Clock, Sio, Spi, Timer, Watchdog, pac};

/// Image definition block. The boot ROM starts only programs that contain such a block.
#[unsafe(link_section = ".start_block")]
#[used]
static IMAGE_DEF: ImageDef = ImageDef::secure_exe();

/// Frequency of the crystal on the board.
const CRYSTAL_HZ: u32 = 12_000_000;

/// The initialized display and watchdog of the board.
pub(crate) struct Board<D> {
    pub(crate) display: D,
    /// Watchdog timer. It resets the chip if the firmware does not feed it for four
    /// seconds.
    pub(crate) watchdog: Watchdog,
}

/// Initializes the board. The display driver uses `line` as its transfer buffer.
///
/// This function must be called only once.
pub(crate) fn init(
    line: &'static mut [u8],
) -> Board<impl DrawTarget<Color = Rgb565> + OriginDimensions> {
    let mut chip = defmt::unwrap!(pac::Peripherals::take());
    let mut watchdog = Watchdog::new(chip.WATCHDOG);
    let Ok(clocks) = init_clocks_and_plls(
        CRYSTAL_HZ,
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

    // These pins match the wiring of common Pico LCD hats.
    let bank = Sio::new(chip.SIO).gpio_bank0;
    let pins = Pins::new(chip.IO_BANK0, chip.PADS_BANK0, bank, &mut chip.RESETS);
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
    let interface = SpiInterface::new(device, data_or_command, line);
    let Ok(display) = Builder::new(ST7789, interface)
        .reset_pin(reset)
        .invert_colors(ColorInversion::Inverted)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut delay)
    else {
        defmt::panic!("display initialization failed");
    };
    let Ok(()) = backlight.set_high();

    watchdog.start(4.secs());
    Board { display, watchdog }
}
