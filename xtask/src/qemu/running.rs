use std::io::{self, BufRead, BufReader, Read};
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use anyhow::{Context, Result, bail};

use crate::report::Report;

/// Longest time to wait for the next line of output. After this time, the run fails.
const TIMEOUT: Duration = Duration::from_secs(300);

/// Line that ends the report of the firmware.
const END: &str = "end";

/// A running QEMU process. The process is killed when this value is dropped.
pub(crate) struct Running {
    qemu: Child,
    /// Lines of the process's standard output.
    lines: Receiver<io::Result<String>>,
}

impl Drop for Running {
    fn drop(&mut self) {
        _ = self.qemu.kill();
        _ = self.qemu.wait();
    }
}

impl Running {
    pub(crate) fn start(mut command: Command) -> Result<Self> {
        command.stdin(Stdio::null());
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut qemu = command
            .spawn()
            .with_context(|| format!("cannot start {}", command.get_program().display()))?;
        let output = qemu.stdout.take().context("QEMU has no output")?;
        let (sender, lines) = channel();
        // A separate thread reads QEMU's output, because a read from a pipe cannot time out. The
        // thread ends when QEMU exits.
        thread::spawn(move || {
            for line in BufReader::new(output).lines() {
                if line.is_err() || sender.send(line).is_err() {
                    break;
                }
            }
        });
        Ok(Self { qemu, lines })
    }

    /// Reads lines until the report ends or QEMU exits. Returns the report.
    pub(crate) fn report(&mut self) -> Result<Report> {
        let mut lines = Vec::new();
        loop {
            match self.lines.recv_timeout(TIMEOUT) {
                Ok(line) => match line?.trim_end() {
                    END => return Ok(Report::new(lines)),
                    line => lines.push(line.to_owned()),
                },
                Err(RecvTimeoutError::Disconnected) => return Ok(Report::new(lines)),
                Err(RecvTimeoutError::Timeout) => {
                    bail!("the firmware hangs; its output:\n{}", Report::new(lines))
                }
            }
        }
    }

    /// Returns the next line that the firmware prints.
    pub(crate) fn line(&self) -> Result<String> {
        let line = self.lines.recv_timeout(TIMEOUT);
        line.context("the firmware prints no further line")?
            .context("cannot read QEMU's output")
    }

    /// Waits until the firmware makes QEMU exit, and returns the report of the firmware.
    pub(crate) fn finish(mut self) -> Result<Report> {
        let report = self.report()?;
        let mut errors = String::new();
        if let Some(mut stderr) = self.qemu.stderr.take() {
            stderr.read_to_string(&mut errors)?;
        }
        let status = self.qemu.wait()?;
        if !status.success() {
            bail!("QEMU failed: {status}\n{errors}");
        }
        Ok(report)
    }
}
