use cortex_m::peripheral::Peripherals;
use embedded_hal::digital::OutputPin;
use measure::Stopwatch;

use crate::buttons::Buttons;
use crate::gpio::{Output, Port};
use crate::pl022::Pl022;
use crate::register::Registers;
use crate::ssd0323::{Pixels, Ssd0323};
use crate::uart::Uart;

/// Period of the system clock in QEMU, where the clock runs at 12.5 MHz after reset.
///
/// The real chip starts from its internal oscillator, at 12 MHz ± 30 %.
const NANOSECONDS_PER_CLOCK: u32 = 80;

// SAFETY: the addresses of the peripherals are from the data sheet. Each peripheral has
// only one driver. The panic handler also uses `UART_0`, but it never returns.
const SYSTEM_CONTROL: Registers = unsafe { Registers::at(0x400F_E000) };
const PORT_A: Port = Port::new(unsafe { Registers::at(0x4000_4000) });
const PORT_C: Port = Port::new(unsafe { Registers::at(0x4000_6000) });
const PORT_D: Port = Port::new(unsafe { Registers::at(0x4000_7000) });
const PORT_E: Port = Port::new(unsafe { Registers::at(0x4002_4000) });
const PORT_F: Port = Port::new(unsafe { Registers::at(0x4002_5000) });
const SSI_0: Registers = unsafe { Registers::at(0x4000_8000) };
const UART_0: Registers = unsafe { Registers::at(0x4000_C000) };

const CLOCK_GATES_1: usize = 0x104;
const CLOCK_GATES_2: usize = 0x108;

/// Peripherals of the board that the firmware uses.
pub(crate) struct Board {
    pub(crate) oled: Ssd0323<'static, Pl022, Output>,
    pub(crate) uart: Uart,
    pub(crate) stopwatch: Stopwatch,
    pub(crate) buttons: Buttons,
}

impl Board {
    /// Initializes the board. Must be called only once.
    pub(crate) fn new(pixels: &'static mut Pixels) -> Self {
        // Enable the clocks of SSI 0, UART 0, and GPIO ports A and C to F.
        SYSTEM_CONTROL.set(CLOCK_GATES_1, 1 << 4 | 1);
        SYSTEM_CONTROL.set(CLOCK_GATES_2, 0b11_1101);
        // A peripheral can be accessed three cycles after its clock is enabled.
        cortex_m::asm::delay(8);

        // UART 0 uses PA0 and PA1. SSI 0 has its clock, chip select and output on PA2, PA3
        // and PA5.
        PORT_A.set_alternate_function(0b10_1111);
        let Ok(()) = PORT_C.output(6).set_high(); // 15 V supply of the panel
        let Ok(()) = PORT_D.output(0).set_high(); // deselects the SD card
        // The SPI clock is 12 MHz / 4 = 3 MHz. The display controller allows up to 4 MHz.
        let spi = Pl022::new(SSI_0, 4);
        let Ok(oled) = Ssd0323::new(spi, PORT_C.output(7), pixels);

        // The up, down, left and right buttons are at PE0 to PE3. The select button is at
        // PF1.
        let buttons = Buttons::new(PORT_E.button_inputs(0b1111), PORT_F.button_inputs(0b10));

        // SAFETY: `new` is called once, and no other code uses the core peripherals.
        let core = unsafe { Peripherals::steal() };
        Self {
            oled,
            uart: Uart::new(UART_0),
            stopwatch: Stopwatch::new(core.SYST, NANOSECONDS_PER_CLOCK),
            buttons,
        }
    }
}

/// Returns the UART for the panic handler.
///
/// No other code uses the UART after the panic handler, because the panic handler never
/// returns.
pub(crate) fn panic_uart() -> Uart {
    Uart::new(UART_0)
}
