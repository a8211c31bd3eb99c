use core::fmt;

use crate::register::Registers;

const DATA: usize = 0x00;
const FLAGS: usize = 0x18;
const DIVISOR: usize = 0x24;
const DIVISOR_FRACTION: usize = 0x28;
const LINE_CONTROL: usize = 0x2C;
const CONTROL: usize = 0x30;

const TRANSMIT_FULL: u32 = 1 << 5;
const EIGHT_BITS_WITH_FIFO: u32 = 0x70;
const ENABLE_TRANSMIT: u32 = 1 << 8 | 1;

/// Driver that sends text through an Arm PL011 UART. The UART uses 115,200 baud, 8 data
/// bits, no parity and 1 stop bit.
pub(crate) struct Uart(Registers);

impl Uart {
    /// Initializes the UART for a system clock of 12 MHz.
    pub(crate) fn new(registers: Registers) -> Self {
        // The baud rate divisor is 12 MHz / (16 * 115,200) = 6 + 33/64.
        registers.write(DIVISOR, 6);
        registers.write(DIVISOR_FRACTION, 33);
        registers.write(LINE_CONTROL, EIGHT_BITS_WITH_FIFO);
        registers.write(CONTROL, ENABLE_TRANSMIT);
        Self(registers)
    }
}

impl fmt::Write for Uart {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            while self.0.read(FLAGS) & TRANSMIT_FULL != 0 {}
            self.0.write(DATA, u32::from(byte));
        }
        Ok(())
    }
}
