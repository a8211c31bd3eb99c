//! QEMU's monitor.

use std::io::{BufRead, BufReader, Write};
use std::os::unix::net::UnixStream;
use std::path::Path;

use anyhow::{Context, Result, bail};

/// A connection to a running QEMU.
pub(crate) struct Monitor {
    answers: BufReader<UnixStream>,
}

impl Monitor {
    /// Connects to the monitor at this socket.
    pub(crate) fn connect(socket: &Path) -> Result<Self> {
        let stream = UnixStream::connect(socket).context("QEMU's monitor does not answer")?;
        let mut monitor = Self {
            answers: BufReader::new(stream),
        };
        monitor.execute(r#"{"execute": "qmp_capabilities"}"#)?;
        Ok(monitor)
    }

    /// Writes the picture on the display to a file: PNG by its name, else PPM.
    pub(crate) fn screendump(&mut self, file: &Path) -> Result<()> {
        let is_png = file.extension().is_some_and(|extension| extension == "png");
        let format = if is_png { "png" } else { "ppm" };
        // Rust's escapes are JSON's, for names that a person would give a file.
        self.execute(&format!(
            r#"{{"execute": "screendump", "arguments": {{"filename": {:?}, "format": "{format}"}}}}"#,
            file.display().to_string(),
        ))
    }

    /// Presses keys or lets them go, all at once.
    pub(crate) fn send_keys(&mut self, keys: &[&str], down: bool) -> Result<()> {
        let event = |key: &&str| {
            let key = format!(r#"{{"type": "qcode", "data": "{key}"}}"#);
            format!(r#"{{"type": "key", "data": {{"down": {down}, "key": {key}}}}}"#)
        };
        let events: Vec<_> = keys.iter().map(event).collect();
        self.execute(&format!(
            r#"{{"execute": "input-send-event", "arguments": {{"events": [{}]}}}}"#,
            events.join(", ")
        ))
    }

    fn execute(&mut self, command: &str) -> Result<()> {
        // At once: QEMU obeys at the last bracket, and may have quit before a
        // line end that comes by itself.
        let command = format!("{command}\n");
        self.answers.get_mut().write_all(command.as_bytes())?;
        let mut line = String::new();
        // Greeting and events come in between.
        while !line.starts_with(r#"{"return""#) {
            line.clear();
            if self.answers.read_line(&mut line)? == 0 || line.starts_with(r#"{"error""#) {
                bail!("QEMU does not {}: {line}", command.trim_end());
            }
        }
        Ok(())
    }
}
