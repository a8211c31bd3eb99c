use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

/// A progress bar on stderr. It appears only if the work takes longer than a second.
pub(crate) struct Progress {
    start: Instant,
    lines: u64,
    done: u64,
    bar: Option<ProgressBar>,
}

impl Progress {
    /// Starts the clock for a rendering of `lines` lines.
    pub(crate) fn new(lines: impl Into<u64>) -> Self {
        Self {
            start: Instant::now(),
            lines: lines.into(),
            done: 0,
            bar: None,
        }
    }

    /// Advances the bar by one line.
    pub(crate) fn line(&mut self) {
        self.done += 1;
        if self.start.elapsed() > Duration::from_secs(1) {
            self.bar
                .get_or_insert_with(|| bar(self.lines))
                .set_position(self.done);
        }
    }

    /// Removes the progress bar and returns the elapsed time.
    pub(crate) fn finish(self) -> Duration {
        if let Some(bar) = self.bar {
            bar.finish_and_clear();
        }
        self.start.elapsed()
    }
}

fn bar(lines: u64) -> ProgressBar {
    let bar = ProgressBar::new(lines);
    match ProgressStyle::with_template("{bar:40} line {pos} of {len}, {eta} left") {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
