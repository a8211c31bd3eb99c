//! What a process takes.

use std::fmt;
use std::fs::{self, File};
use std::path::Path;
use std::process::Command;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};
use wait4::Wait4;

/// What a process took from its start to its end.
pub(super) struct Price {
    wall: Duration,
    /// Of the wall clock's, by its own account.
    tracing: Duration,
    /// Of all its threads, in user and kernel mode.
    processor: Duration,
    /// The most that it had in memory, in bytes.
    memory: u64,
}

/// Runs it to a good end. What it prints goes to the log, where its own account
/// of tracing follows `label`.
pub(super) fn price(command: &mut Command, log: &Path, label: &str) -> Result<Price> {
    let file = File::create(log)?;
    command.stdout(file.try_clone()?).stderr(file);
    let start = Instant::now();
    let mut child = command
        .spawn()
        .with_context(|| format!("{command:?} does not start"))?;
    let used = child.wait4()?;
    let wall = start.elapsed();

    let printed = String::from_utf8_lossy(&fs::read(log)?).into_owned();
    if !used.status.success() {
        bail!("{command:?} failed: {}\n{printed}", used.status);
    }
    let tracing = seconds(&printed, label);
    Ok(Price {
        wall,
        tracing: tracing.with_context(|| format!("no {label:?} in {}", log.display()))?,
        processor: used.rusage.utime + used.rusage.stime,
        memory: used.rusage.maxrss,
    })
}

/// The number before the last "s" or "seconds" of the line that has this label.
fn seconds(printed: &str, label: &str) -> Option<Duration> {
    let line = printed.lines().find(|line| line.contains(label))?;
    let (rest, _) = line.rsplit_once(" s")?;
    let number = rest.rsplit([' ', '(']).next()?;
    Duration::try_from_secs_f64(number.parse().ok()?).ok()
}

/// The cells of a row.
impl fmt::Display for Price {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for time in [self.wall, self.tracing, self.processor] {
            write!(f, "{:.2} s | ", time.as_secs_f64())?;
        }
        write!(f, "{:.0} MB", self.memory as f64 / 1e6)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_accounts_of_time_are_read() {
        let printed = "checksum: 1\ntime: 0.205 s\n  \
            Trace Time:       0 hours  1 minutes  2 seconds (62.541 seconds)\n";
        let read = |label| seconds(printed, label);
        assert_eq!(read("time:"), Some(Duration::from_millis(205)));
        assert_eq!(read("Trace Time:"), Some(Duration::from_millis(62_541)));
        assert_eq!(read("Parse Time:"), None);
    }
}
