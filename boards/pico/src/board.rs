use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use embedded_hal::digital::OutputPin;
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use rp2040_hal::clocks::init_clocks_and_plls;
use rp2040_hal::fugit::{ExtU32, RateExtU32};
use rp2040_hal::gpio::{
    self, DynPinId, FunctionSioInput, FunctionSioOutput, PinState, PullDown, PullUp,
};
use rp2040_hal::spi::Enabled;
use rp2040_hal::usb::UsbBus;
use rp2040_hal::{Clock, Sio, Spi, Timer, Watchdog, pac};

use crate::buttons::{Button, Buttons};
use crate::input::Input;
use crate::pins::{self, LcdClock, LcdData, LcdSpi, Pins};
use crate::scenes::Buffer;
use crate::usb::{self, SceneReceiver};

/// Second-stage bootloader. It maps the flash of the Pico into the address space.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// Frequency of the crystal. The core runs at 125 MHz.
const CRYSTAL_HZ: u32 = 12_000_000;

/// Input pin of a button.
pub(crate) type Pin = gpio::Pin<DynPinId, FunctionSioInput, PullUp>;

/// Transfer buffer of the display driver. It holds one line of 16-bit pixels.
pub(crate) type LineBuffer = [u8; 2 * pins::LCD_SIZE.0 as usize];

type Output = gpio::Pin<DynPinId, FunctionSioOutput, PullDown>;
type Bus = Spi<Enabled, LcdSpi, (LcdData, LcdClock)>;
type Interface = SpiInterface<'static, ExclusiveDevice<Bus, Output, NoDelay>, Output>;

/// Display on the SPI bus. The firmware only writes to the display, and an SPI write cannot
/// fail.
pub(crate) type Display = mipidsi::Display<Interface, ST7789, Output>;

/// Peripherals of the board that the firmware uses.
pub(crate) struct Board {
    pub(crate) display: Display,
    /// LED that is on while a picture is drawn.
    pub(crate) led: Output,
    pub(crate) input: Input,
}

impl Board {
    /// Initializes the board. Must be called only once.
    ///
    /// # Panics
    /// Panics if the crystal or the display configuration is invalid.
    pub(crate) fn new(
        line: &'static mut LineBuffer,
        receiver: &'static mut SceneReceiver,
        validation_buffer: &'static mut Buffer,
    ) -> Self {
        let mut pac = pac::Peripherals::take().expect("the board is initialized once");
        let mut watchdog = Watchdog::new(pac.WATCHDOG);
        let clocks = init_clocks_and_plls(
            CRYSTAL_HZ,
            pac.XOSC,
            pac.CLOCKS,
            pac.PLL_SYS,
            pac.PLL_USB,
            &mut pac.RESETS,
            &mut watchdog,
        )
        .unwrap_or_else(|_| panic!("no clock configuration for a crystal of {} Hz", CRYSTAL_HZ));
        let mut timer = Timer::new(pac.TIMER, &mut pac.RESETS, &clocks);
        let sio = Sio::new(pac.SIO);
        let pins = Pins::new(
            pac.IO_BANK0,
            pac.PADS_BANK0,
            sio.gpio_bank0,
            &mut pac.RESETS,
        );
        watchdog.pause_on_debug(true);
        // The watchdog resets the board if the firmware does not feed it for two seconds.
        watchdog.start(2.secs());

        let (registers, memory) = (pac.USBCTRL_REGS, pac.USBCTRL_DPRAM);
        let bus = UsbBus::new(registers, memory, clocks.usb_clock, true, &mut pac.RESETS);
        usb::start(bus, receiver, timer);

        let spi_pins = (pins.lcd_data.reconfigure(), pins.lcd_clock.reconfigure());
        let spi = Spi::<_, LcdSpi, _>::new(pins::lcd_spi!(pac), spi_pins);
        let clock = clocks.peripheral_clock.freq();
        let bus = spi.init(
            &mut pac.RESETS,
            clock,
            pins::LCD_HZ.Hz(),
            embedded_hal::spi::MODE_0,
        );
        let select = pins.lcd_cs.into_push_pull_output_in_state(PinState::High);
        let Ok(device) = ExclusiveDevice::new_no_delay(bus, select.into_dyn_pin());
        let data_or_command = pins.lcd_dc.into_push_pull_output().into_dyn_pin();
        let (width, height) = pins::LCD_SIZE;
        let mut display = Builder::new(ST7789, SpiInterface::new(device, data_or_command, line))
            .reset_pin(pins.lcd_reset.into_push_pull_output().into_dyn_pin())
            .display_size(width, height)
            .orientation(pins::LCD_ORIENTATION)
            .invert_colors(pins::LCD_INVERSION)
            .init(&mut timer)
            .unwrap_or_else(|_| panic!("display initialization failed"));
        // Clear the display first, because its memory is undefined after power-on.
        let Ok(()) = display.clear(Rgb565::BLACK);
        let Ok(()) = pins.lcd_backlight.into_push_pull_output().set_high();

        let buttons = Buttons::new([
            (Button::Left, pins.left.into_pull_up_input().into_dyn_pin()),
            (
                Button::Right,
                pins.right.into_pull_up_input().into_dyn_pin(),
            ),
            (Button::Up, pins.up.into_pull_up_input().into_dyn_pin()),
            (Button::Down, pins.down.into_pull_up_input().into_dyn_pin()),
            (Button::Next, pins.next.into_pull_up_input().into_dyn_pin()),
        ]);
        Self {
            display,
            led: pins.led.into_push_pull_output().into_dyn_pin(),
            input: Input::new(watchdog, buttons, timer, validation_buffer),
        }
    }
}
