use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Time until the bar appears.
const DELAY: Duration = Duration::from_millis(500);

/// Interval in which the bar is drawn, even if no line is complete.
const REFRESH: Duration = Duration::from_millis(250);

/// A progress bar on stderr, if stderr is a terminal. It appears after half a second, even if the
/// first line takes longer. It disappears when this value is dropped.
pub(crate) struct Progress {
    start: Instant,
    bar: ProgressBar,
    /// Sender that is dropped to end the thread.
    running: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Progress {
    /// Starts the clock for a rendering of `lines` lines.
    pub(crate) fn new(lines: impl Into<u64>) -> Self {
        let bar = ProgressBar::with_draw_target(Some(lines.into()), ProgressDrawTarget::hidden());
        let (running, ended) = channel();
        let shown = bar.clone();
        Self {
            start: Instant::now(),
            bar,
            running: Some(running),
            thread: Some(thread::spawn(move || show(&shown, &ended))),
        }
    }

    /// Adds lines to the rendering.
    pub(crate) fn add_lines(&mut self, lines: impl Into<u64>) {
        self.bar.inc_length(lines.into());
    }

    /// Advances the bar by one line.
    pub(crate) fn line(&mut self) {
        self.bar.inc(1);
    }

    /// Removes the progress bar and returns the elapsed time.
    pub(crate) fn finish(self) -> Duration {
        self.start.elapsed()
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        drop(self.running.take());
        if let Some(thread) = self.thread.take() {
            _ = thread.join();
        }
    }
}

/// Shows the bar from the delay until the end of the rendering.
fn show(bar: &ProgressBar, ended: &Receiver<()>) {
    if ended.recv_timeout(DELAY) != Err(RecvTimeoutError::Timeout) {
        return;
    }
    bar.set_draw_target(ProgressDrawTarget::stderr());
    if let Ok(style) = ProgressStyle::with_template("{bar:40} line {pos} of {len}, {eta} left") {
        bar.set_style(style);
    }
    bar.enable_steady_tick(REFRESH);
    _ = ended.recv();
    bar.finish_and_clear();
}
