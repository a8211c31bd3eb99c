use core::convert::Infallible;

use embedded_hal::digital::InputPin;

/// A button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Button {
    Left,
    Right,
    Up,
    Down,
    Next,
}

/// Buttons that connect their pins to ground.
pub(crate) struct Buttons<P> {
    buttons: [(Button, P); 5],
    /// What was pressed when it was last looked at.
    last: Option<Button>,
}

impl<P: InputPin<Error = Infallible>> Buttons<P> {
    pub(crate) fn new(buttons: [(Button, P); 5]) -> Self {
        Self {
            buttons,
            last: None,
        }
    }

    /// A button that is pressed now and was not when this was last asked.
    pub(crate) fn pressed(&mut self) -> Option<Button> {
        let mut buttons = self.buttons.iter_mut();
        let now = buttons.find_map(|(button, pin)| {
            let Ok(is_pressed) = pin.is_low();
            is_pressed.then_some(*button)
        });
        let before = core::mem::replace(&mut self.last, now);
        now.filter(|_| now != before)
    }
}
