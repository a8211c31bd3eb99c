//! Controls a running QEMU by its monitor protocol, QMP.

use std::io::{BufRead, BufReader, Write};
use std::os::unix::net::UnixStream;
use std::path::Path;

use anyhow::{Context, Result, bail};

/// A connection to the monitor of a running QEMU.
pub(crate) struct Monitor {
    answers: BufReader<UnixStream>,
}

impl Monitor {
    /// Connects to QEMU's monitor at a Unix socket.
    pub(crate) fn connect(socket: &Path) -> Result<Self> {
        let stream = UnixStream::connect(socket).context("cannot connect to QEMU's monitor")?;
        let mut monitor = Self {
            answers: BufReader::new(stream),
        };
        monitor.execute(r#"{"execute": "qmp_capabilities"}"#)?;
        Ok(monitor)
    }

    /// Writes a screenshot: a PNG if the file name ends in `.png`, else a PPM.
    pub(crate) fn screendump(&mut self, file: &Path) -> Result<()> {
        let is_png = file.extension().is_some_and(|extension| extension == "png");
        let format = if is_png { "png" } else { "ppm" };
        // `{:?}` writes the file name as a Rust string literal. For usual names, this is also a
        // valid JSON string.
        self.execute(&format!(
            r#"{{"execute": "screendump", "arguments": {{"filename": {:?}, "format": "{format}"}}}}"#,
            file.display().to_string(),
        ))
    }

    /// Presses or releases several keys at once.
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
        // The command and its newline are sent in one write. QEMU executes the command when the
        // last bracket arrives. It may then quit before it receives a newline from a second write.
        let command = format!("{command}\n");
        self.answers.get_mut().write_all(command.as_bytes())?;
        let mut line = String::new();
        // Skips other messages that QEMU may send before the answer: its greeting and events.
        while !line.starts_with(r#"{"return""#) {
            line.clear();
            if self.answers.read_line(&mut line)? == 0 || line.starts_with(r#"{"error""#) {
                bail!("QEMU's monitor rejected {}: {line}", command.trim_end());
            }
        }
        Ok(())
    }
}
