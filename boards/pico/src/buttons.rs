use core::convert::Infallible;

use embedded_hal::digital::InputPin;

/// Buttons of the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Button {
    Left,
    Right,
    Up,
    Down,
    Next,
}

/// Driver for the buttons. A pressed button connects its pin to ground.
pub(crate) struct Buttons<P> {
    buttons: [(Button, P); 5],
    /// Button that was pressed at the last poll.
    previous: Option<Button>,
}

impl<P: InputPin<Error = Infallible>> Buttons<P> {
    pub(crate) fn new(buttons: [(Button, P); 5]) -> Self {
        Self {
            buttons,
            previous: None,
        }
    }

    /// Returns a button that was pressed since the last call.
    pub(crate) fn poll(&mut self) -> Option<Button> {
        let mut buttons = self.buttons.iter_mut();
        let current = buttons.find_map(|(button, pin)| {
            let Ok(is_pressed) = pin.is_low();
            is_pressed.then_some(*button)
        });
        let previous = core::mem::replace(&mut self.previous, current);
        current.filter(|_| current != previous)
    }
}
