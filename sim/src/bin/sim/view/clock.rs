use std::time::Duration;

use whitted::Real;

/// Time of an animation. It runs while a frame is drawn, and the next frame shows the time that has
/// passed by then.
#[derive(Default)]
pub(super) struct Clock {
    now: Real,
    /// Time of the frame that is drawn.
    frame: Real,
    is_paused: bool,
}

impl Clock {
    /// Returns the time of the current frame, in seconds.
    pub(super) fn frame(&self) -> Real {
        self.frame
    }

    pub(super) fn pause(&mut self) {
        self.is_paused = !self.is_paused;
    }

    /// Advances the time, unless it is paused.
    pub(super) fn advance(&mut self, passed: Duration) {
        if !self.is_paused {
            let passed = Real::saturating_from_num(passed.as_secs_f64());
            self.now = self.now.saturating_add(passed);
        }
    }

    /// Starts the next frame. Returns false if no time has passed since the current frame.
    pub(super) fn next_frame(&mut self) -> bool {
        let has_passed = self.now > self.frame;
        self.frame = self.now;
        has_passed
    }
}
