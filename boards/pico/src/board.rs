use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use embedded_hal::delay::DelayNs;
use embedded_hal::digital::OutputPin;
use embedded_hal_bus::spi::{ExclusiveDevice, NoDelay};
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use rp2040_hal::clocks::init_clocks_and_plls;
use rp2040_hal::fugit::{ExtU32, RateExtU32};
use rp2040_hal::gpio::{
    DynPinId, FunctionSioInput, FunctionSioOutput, Pin, PinState, PullDown, PullUp,
};
use rp2040_hal::spi::Enabled;
use rp2040_hal::usb::UsbBus;
use rp2040_hal::{Clock, Sio, Spi, Timer, Watchdog, pac};

use crate::buttons::{Button, Buttons};
use crate::pins::{self, LcdClock, LcdData, LcdSpi, Pins};
use crate::scenes::Scenes;
use crate::usb::{self, Inbox};

/// The second stage of booting, which makes the Pico's flash readable as memory.
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// The Pico's crystal; the core's clock is 125 MHz.
const CRYSTAL_HZ: u32 = 12_000_000;

/// What the display is sent at once: a line.
pub(crate) type LineBuffer = [u8; 2 * pins::LCD_SIZE.0 as usize];

type Output = Pin<DynPinId, FunctionSioOutput, PullDown>;
type Input = Pin<DynPinId, FunctionSioInput, PullUp>;
type Bus = Spi<Enabled, LcdSpi, (LcdData, LcdClock)>;
type Wires = SpiInterface<'static, ExclusiveDevice<Bus, Output, NoDelay>, Output>;

/// The display. As its wires go one way only, no error comes back.
pub(crate) type Display = mipidsi::Display<Wires, ST7789, Output>;

/// What somebody asks for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Event {
    Press(Button),
    /// The scene with this number, which came just now.
    Sent(usize),
}

/// What the firmware uses of the board.
pub(crate) struct Board {
    pub(crate) display: Display,
    pub(crate) scenes: &'static mut Scenes,
    /// Restarts the board when it is not fed for two seconds.
    watchdog: Watchdog,
    /// Lit while a picture is drawn.
    pub(crate) led: Output,
    buttons: Buttons<Input>,
    timer: Timer,
}

impl Board {
    /// Sets the board up, once. What cannot be set up is a mistake in this
    /// crate: a panic tells of it.
    pub(crate) fn take(
        line: &'static mut LineBuffer,
        scenes: &'static mut Scenes,
        inbox: &'static mut Inbox,
    ) -> Self {
        let mut pac = pac::Peripherals::take().expect("the board is taken once");
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
        .unwrap_or_else(|_| panic!("the crystal is not one of {} Hz", CRYSTAL_HZ));
        let mut timer = Timer::new(pac.TIMER, &mut pac.RESETS, &clocks);
        let sio = Sio::new(pac.SIO);
        let pins = Pins::new(
            pac.IO_BANK0,
            pac.PADS_BANK0,
            sio.gpio_bank0,
            &mut pac.RESETS,
        );
        watchdog.pause_on_debug(true);
        watchdog.start(2.secs());

        let (registers, memory) = (pac.USBCTRL_REGS, pac.USBCTRL_DPRAM);
        let bus = UsbBus::new(registers, memory, clocks.usb_clock, true, &mut pac.RESETS);
        usb::start(bus, inbox, timer);

        let wires = (pins.lcd_data.reconfigure(), pins.lcd_clock.reconfigure());
        let spi = Spi::<_, LcdSpi, _>::new(pins::lcd_spi!(pac), wires);
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
            .unwrap_or_else(|_| panic!("the driver does not support such a display"));
        // The display's memory is noise until it is written.
        let Ok(()) = display.clear(Rgb565::BLACK);
        let Ok(()) = pins.lcd_backlight.into_push_pull_output().set_high();

        Self {
            display,
            scenes,
            watchdog,
            led: pins.led.into_push_pull_output().into_dyn_pin(),
            buttons: Buttons::new([
                (Button::Left, pins.left.into_pull_up_input().into_dyn_pin()),
                (
                    Button::Right,
                    pins.right.into_pull_up_input().into_dyn_pin(),
                ),
                (Button::Up, pins.up.into_pull_up_input().into_dyn_pin()),
                (Button::Down, pins.down.into_pull_up_input().into_dyn_pin()),
                (Button::Next, pins.next.into_pull_up_input().into_dyn_pin()),
            ]),
            timer,
        }
    }

    /// What was asked for since the last look, if anything; feeds the watchdog.
    pub(crate) fn event(&mut self) -> Option<Event> {
        self.watchdog.feed();
        let sent = || self.scenes.received().map(Event::Sent);
        self.buttons.pressed().map(Event::Press).or_else(sent)
    }

    /// Waits for something to be asked for. Buttons bounce for less than the
    /// time between two looks at them.
    pub(crate) fn wait(&mut self) -> Event {
        loop {
            self.timer.delay_ms(10);
            if let Some(event) = self.event() {
                return event;
            }
        }
    }
}
