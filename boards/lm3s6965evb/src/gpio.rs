use core::convert::Infallible;

use embedded_hal::digital::{ErrorType, OutputPin};

use crate::register::Registers;

const DIRECTION: usize = 0x400;
const BOTH_EDGES: usize = 0x408;
const INTERRUPT_MASK: usize = 0x410;
const MASKED_STATUS: usize = 0x418;
const INTERRUPT_CLEAR: usize = 0x41C;
const ALTERNATE_FUNCTION: usize = 0x420;
const PULL_UP: usize = 0x510;
const DIGITAL_ENABLE: usize = 0x51C;

/// How long contacts bounce: 5 ms at 12 MHz.
const BOUNCE_CLOCKS: u32 = 60_000;

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

    /// Makes the pins of this mask inputs for buttons, which pull them low.
    pub(crate) fn buttons(self, pins: u32) -> Inputs {
        self.0.set(PULL_UP, pins);
        self.0.set(DIGITAL_ENABLE, pins);
        self.0.set(BOTH_EDGES, pins);
        self.0.write(INTERRUPT_CLEAR, pins);
        self.0.set(INTERRUPT_MASK, pins);
        let mut inputs = Inputs {
            port: self.0,
            early: 0,
        };
        inputs.early = inputs.low(pins);
        inputs
    }
}

/// Pins that buttons pull low. The port remembers that one has changed.
pub(crate) struct Inputs {
    port: Registers,
    /// Pins that have been low since before anybody looked. In QEMU these are all.
    early: u32,
}

impl Inputs {
    /// Those of the pins of a mask that are low.
    fn low(&self, pins: u32) -> u32 {
        pins & !self.port.read((pins << 2) as usize)
    }

    /// Whether no pin has changed that was not asked for since.
    pub(crate) fn are_quiet(&self) -> bool {
        self.port.read(MASKED_STATUS) == 0
    }

    /// Whether the button at a pin was pressed since this was last asked: it is
    /// down now, or was from the start and is let go.
    pub(crate) fn is_pressed(&mut self, pin: u8) -> bool {
        let mask = 1 << pin;
        if self.port.read(MASKED_STATUS) & mask == 0 {
            return false;
        }
        cortex_m::asm::delay(BOUNCE_CLOCKS);
        self.port.write(INTERRUPT_CLEAR, mask);
        let pressed = (self.low(mask) | self.early) & mask;
        self.early &= !mask;
        pressed != 0
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
