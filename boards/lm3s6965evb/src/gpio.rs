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

/// Debounce delay in clocks: 5 ms at 12 MHz.
const DEBOUNCE_CLOCKS: u32 = 60_000;

/// GPIO port of the chip.
#[derive(Clone, Copy)]
pub(crate) struct Port(Registers);

impl Port {
    /// Creates a port from its registers.
    pub(crate) const fn new(registers: Registers) -> Self {
        Self(registers)
    }

    /// Assigns the pins in the bit mask `pins` to the peripherals that share these pins,
    /// such as the UART.
    pub(crate) fn set_alternate_function(self, pins: u32) {
        self.0.set(ALTERNATE_FUNCTION, pins);
        self.0.set(DIGITAL_ENABLE, pins);
    }

    /// Configures a pin as output.
    pub(crate) fn output(self, pin: u8) -> Output {
        let mask = 1 << pin;
        self.0.set(DIRECTION, mask);
        self.0.set(DIGITAL_ENABLE, mask);
        Output { port: self.0, mask }
    }

    /// Configures the pins in the bit mask `pins` as inputs with pull-ups. The buttons must
    /// connect these pins to ground.
    pub(crate) fn button_inputs(self, pins: u32) -> Inputs {
        self.0.set(PULL_UP, pins);
        self.0.set(DIGITAL_ENABLE, pins);
        self.0.set(BOTH_EDGES, pins);
        self.0.write(INTERRUPT_CLEAR, pins);
        self.0.set(INTERRUPT_MASK, pins);
        let mut inputs = Inputs {
            port: self.0,
            low_at_start: 0,
        };
        inputs.low_at_start = inputs.low_pins(pins);
        inputs
    }
}

/// Input pins of a port, for buttons that connect the pins to ground. The port latches each
/// change of a pin, so that the firmware can read the change later.
pub(crate) struct Inputs {
    port: Registers,
    /// Mask of the pins that were low at startup and have not changed since. In QEMU, all
    /// pins start low.
    low_at_start: u32,
}

impl Inputs {
    /// Returns the bits of the mask `pins` whose pins are low.
    fn low_pins(&self, pins: u32) -> u32 {
        pins & !self.port.read((pins << 2) as usize)
    }

    /// Returns true if the port has latched a pin change that has not been read yet.
    pub(crate) fn has_changes(&self) -> bool {
        self.port.read(MASKED_STATUS) != 0
    }

    /// Returns true if the button at `pin` was pressed since the last call.
    ///
    /// A press is a change of the pin to low. For a pin that was low at startup, the first
    /// change counts as a press.
    pub(crate) fn take_press(&mut self, pin: u8) -> bool {
        let mask = 1 << pin;
        if self.port.read(MASKED_STATUS) & mask == 0 {
            return false;
        }
        cortex_m::asm::delay(DEBOUNCE_CLOCKS);
        self.port.write(INTERRUPT_CLEAR, mask);
        let pressed = (self.low_pins(mask) | self.low_at_start) & mask;
        self.low_at_start &= !mask;
        pressed != 0
    }
}

/// Output pin.
pub(crate) struct Output {
    port: Registers,
    mask: u32,
}

impl Output {
    /// Sets the pin level.
    ///
    /// The data register has many addresses. Bits 2 to 9 of the address select the pins
    /// that a write changes. The other pins of the port keep their levels.
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
