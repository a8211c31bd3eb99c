use cortex_m::interrupt::InterruptNumber;
use cortex_m::peripheral::NVIC;

use crate::gpio::Inputs;

/// Buttons of the board.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Button {
    Up,
    Down,
    Left,
    Right,
    Select,
}

/// Driver of the arrow buttons and the select button.
///
/// The GPIO ports remember a press until the driver reads it, so no press is lost while the
/// firmware traces a line. The interrupts of the ports wake the core from sleep. The driver
/// disables interrupts globally, so that no interrupt handler runs.
pub(crate) struct Buttons {
    arrows: Inputs,
    select: Inputs,
}

impl Buttons {
    /// Creates the driver. The arrow buttons are at pins 0 to 3 of `arrows`. The select
    /// button is at pin 1 of `select`.
    pub(crate) fn new(arrows: Inputs, select: Inputs) -> Self {
        cortex_m::interrupt::disable();
        for port in [Interrupt::PortE, Interrupt::PortF] {
            // SAFETY: interrupts are disabled globally. Unmasking one therefore runs no
            // interrupt handler and interrupts no critical section.
            unsafe { NVIC::unmask(port) };
        }
        Self { arrows, select }
    }

    /// Returns a button that was pressed since the last call.
    pub(crate) fn take_press(&mut self) -> Option<Button> {
        use Button::{Down, Left, Right, Select, Up};
        let arrow = |(pin, button)| self.arrows.take_press(pin).then_some(button);
        let arrows = [(0, Up), (1, Down), (2, Left), (3, Right)];
        let pressed = arrows.into_iter().find_map(arrow);
        pressed.or_else(|| self.select.take_press(1).then_some(Select))
    }

    /// Sleeps until a button is pressed.
    pub(crate) fn wait(&mut self) -> Button {
        loop {
            if let Some(button) = self.take_press() {
                return button;
            }
            // Do not sleep if a port has already latched a pin change, because that change
            // does not wake the core again.
            if !self.arrows.has_changes() && !self.select.has_changes() {
                cortex_m::asm::wfi();
                NVIC::unpend(Interrupt::PortE);
                NVIC::unpend(Interrupt::PortF);
            }
        }
    }
}

/// Interrupts of the two GPIO ports that the buttons are connected to.
#[derive(Clone, Copy)]
enum Interrupt {
    PortE = 4,
    PortF = 30,
}

// SAFETY: the interrupt numbers are from the data sheet.
unsafe impl InterruptNumber for Interrupt {
    fn number(self) -> u16 {
        self as u16
    }
}
