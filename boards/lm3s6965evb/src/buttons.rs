use cortex_m::interrupt::InterruptNumber;
use cortex_m::peripheral::NVIC;

use crate::gpio::Inputs;

/// A button of the board.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Button {
    Up,
    Down,
    Left,
    Right,
    Select,
}

/// The arrow buttons and the select button.
///
/// Ports remember a press until it is asked for, so none is missed while a line
/// is traced; and their interrupts end the core's sleep, but are never taken.
pub(crate) struct Buttons {
    arrows: Inputs,
    select: Inputs,
}

impl Buttons {
    /// At the pins 0 to 3, and 1.
    pub(crate) fn new(arrows: Inputs, select: Inputs) -> Self {
        cortex_m::interrupt::disable();
        for port in [Interrupt::PortE, Interrupt::PortF] {
            // SAFETY: no interrupt is taken from here on, so none breaks a critical
            // section.
            unsafe { NVIC::unmask(port) };
        }
        Self { arrows, select }
    }

    /// A button that was pressed since it was last asked for.
    pub(crate) fn pressed(&mut self) -> Option<Button> {
        use Button::{Down, Left, Right, Select, Up};
        let arrow = |(pin, button)| self.arrows.is_pressed(pin).then_some(button);
        let arrows = [(0, Up), (1, Down), (2, Left), (3, Right)];
        let pressed = arrows.into_iter().find_map(arrow);
        pressed.or_else(|| self.select.is_pressed(1).then_some(Select))
    }

    /// Sleeps until a button is pressed.
    pub(crate) fn wait(&mut self) -> Button {
        loop {
            if let Some(button) = self.pressed() {
                return button;
            }
            // A port that has more to tell will not wake the core anew.
            if self.arrows.are_quiet() && self.select.are_quiet() {
                cortex_m::asm::wfi();
                NVIC::unpend(Interrupt::PortE);
                NVIC::unpend(Interrupt::PortF);
            }
        }
    }
}

/// Of the ports that the buttons are on.
#[derive(Clone, Copy)]
enum Interrupt {
    PortE = 4,
    PortF = 30,
}

// SAFETY: the chip's data sheet has these interrupts at these numbers.
unsafe impl InterruptNumber for Interrupt {
    fn number(self) -> u16 {
        self as u16
    }
}
