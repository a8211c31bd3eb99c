use rp2040_hal::fugit::MicrosDurationU64;
use rp2040_hal::timer::Instant;
use rp2040_hal::{Timer, Watchdog};

use crate::board::Pin;
use crate::buttons::{Button, Buttons};
use crate::scenes::Buffer;
use crate::usb;

/// Time between two polls of the buttons. A button bounces for less than this time.
const BUTTON_PERIOD: MicrosDurationU64 = MicrosDurationU64::millis(10);

/// User input.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Event {
    /// A button was pressed.
    Press(Button),
    /// A valid scene arrived over USB.
    Received,
}

/// Buttons, received scenes, and the watchdog, which is fed whenever the firmware polls for input.
pub(crate) struct Input {
    watchdog: Watchdog,
    buttons: Buttons<Pin>,
    timer: Timer,
    /// Time of the last poll of the buttons.
    last_poll: Instant,
    /// Memory that the firmware needs to validate a received scene while it draws another
    /// scene.
    validation_buffer: &'static mut Buffer,
}

impl Input {
    pub(crate) fn new(
        watchdog: Watchdog,
        buttons: Buttons<Pin>,
        timer: Timer,
        validation_buffer: &'static mut Buffer,
    ) -> Self {
        Self {
            watchdog,
            buttons,
            timer,
            last_poll: timer.get_counter(),
            validation_buffer,
        }
    }

    /// Feeds the watchdog. At most every 10 ms, returns the user input since the last call.
    ///
    /// After [`Event::Received`], the caller must store the scene with
    /// [`Scenes::store_received`](crate::scenes::Scenes::store_received).
    pub(crate) fn poll(&mut self) -> Option<Event> {
        self.watchdog.feed();
        let now = self.timer.get_counter();
        if now - self.last_poll < BUTTON_PERIOD {
            return None;
        }
        self.last_poll = now;
        if let Some(button) = self.buttons.poll() {
            return Some(Event::Press(button));
        }
        let is_received = usb::receive(|scene| self.validation_buffer.decode(scene).map(drop));
        is_received.then_some(Event::Received)
    }

    /// Waits for user input and returns it.
    pub(crate) fn wait(&mut self) -> Event {
        loop {
            if let Some(event) = self.poll() {
                return event;
            }
        }
    }
}
