use cortex_m::peripheral::Peripherals;
use embedded_hal::digital::OutputPin;
use measure::Stopwatch;

use crate::buttons::Buttons;
use crate::gpio::{Output, Port};
use crate::pl022::Pl022;
use crate::register::Registers;
use crate::ssd0323::{Pixels, Ssd0323};
use crate::uart::Uart;

/// Of the system clock at reset, as QEMU has it. A chip starts from its
/// internal oscillator, at 12 MHz ± 30 %.
const NANOSECONDS_PER_CLOCK: u32 = 80;

// SAFETY of these: the chip's data sheet has these peripherals at these
// addresses, and each is named here only. `UART` is used for panics too.
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

/// What the firmware uses of the board.
pub(crate) struct Board {
    pub(crate) oled: Ssd0323<'static, Pl022, Output>,
    pub(crate) uart: Uart,
    pub(crate) stopwatch: Stopwatch,
    pub(crate) buttons: Buttons,
}

impl Board {
    /// Sets the board up; to be called once.
    pub(crate) fn new(pixels: &'static mut Pixels) -> Self {
        // SSI 0 and UART 0; ports A and C to F.
        SYSTEM_CONTROL.set(CLOCK_GATES_1, 1 << 4 | 1);
        SYSTEM_CONTROL.set(CLOCK_GATES_2, 0b11_1101);
        // The clocks take three cycles to arrive.
        cortex_m::asm::delay(8);

        // UART 0 on PA0 and PA1; SSI 0's clock, select and output on PA2, 3, 5.
        PORT_A.hand_over(0b10_1111);
        let Ok(()) = PORT_C.output(6).set_high(); // the panel's 15 V
        let Ok(()) = PORT_D.output(0).set_high(); // deselects the SD card
        // 12 MHz / 4; the controller takes up to 4 MHz.
        let spi = Pl022::new(SSI_0, 4);
        let Ok(oled) = Ssd0323::new(spi, PORT_C.output(7), pixels);

        // Up, down, left, right; select.
        let buttons = Buttons::new(PORT_E.buttons(0b1111), PORT_F.buttons(0b10));

        // SAFETY: this is called once, and nothing else uses the core's peripherals.
        let core = unsafe { Peripherals::steal() };
        Self {
            oled,
            uart: Uart::new(UART_0),
            stopwatch: Stopwatch::new(core.SYST, NANOSECONDS_PER_CLOCK),
            buttons,
        }
    }
}

/// The UART for last words: whoever else had it never uses it again.
pub(crate) fn last_words() -> Uart {
    Uart::new(UART_0)
}
