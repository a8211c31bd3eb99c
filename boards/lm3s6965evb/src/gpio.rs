use core::convert::Infallible;

use embedded_hal::digital::{ErrorType, OutputPin};

use crate::register::Registers;

const DIRECTION: usize = 0x400;
const ALTERNATE_FUNCTION: usize = 0x420;
const DIGITAL_ENABLE: usize = 0x51C;

/// One of the chip's GPIO ports.
#[derive(Clone, Copy)]
pub(crate) struct Port(Registers);

impl Port {
    /// The port whose registers these are.
    pub(crate) const fn new(registers: Registers) -> Self {
        Self(registers)
    }

    /// Hands the pins of this mask to their peripherals.
    pub(crate) fn hand_over(self, pins: u32) {
        self.0.set(ALTERNATE_FUNCTION, pins);
        self.0.set(DIGITAL_ENABLE, pins);
    }

    /// Makes a pin an output.
    pub(crate) fn output(self, pin: u8) -> Output {
        let mask = 1 << pin;
        self.0.set(DIRECTION, mask);
        self.0.set(DIGITAL_ENABLE, mask);
        Output { port: self.0, mask }
    }
}

/// A pin that drives its wire.
pub(crate) struct Output {
    port: Registers,
    mask: u32,
}

impl Output {
    /// The data register's address carries the mask of the pins that a write
    /// reaches, so pins of a port do not disturb each other.
    fn drive(&mut self, levels: u32) {
        self.port.write((self.mask << 2) as usize, levels);
    }
}

impl ErrorType for Output {
    type Error = Infallible;
}

impl OutputPin for Output {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.drive(0);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.drive(self.mask);
        Ok(())
    }
}
