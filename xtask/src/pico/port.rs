//! Connects the emulator with the host by a pseudo-terminal, which replaces the USB cable.

use std::path::{Path, PathBuf};
use std::process::Stdio;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, bail};
use serial2::SerialPort;

/// Longest time to wait for an answer. The emulator is a few times slower than the board.
const TIMEOUT: Duration = Duration::from_secs(60);

/// A pseudo-terminal. One end belongs to the emulator, the other end to the host.
pub(super) struct Port {
    device: SerialPort,
    /// The host's end stays open, because the terminal exists only while this end is open.
    host: SerialPort,
    path: PathBuf,
}

impl Port {
    pub(super) fn new() -> Result<Self> {
        let (device, mut host) = SerialPort::pair().context("cannot open a pseudo-terminal")?;
        host.set_read_timeout(Duration::from_millis(100))?;
        let name = rustix::pty::ptsname(&device, Vec::new())?;
        Ok(Self {
            device,
            host,
            path: name.to_str()?.into(),
        })
    }

    /// Returns the path of the terminal for programs on the host.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Returns the emulator's end of the terminal.
    pub(super) fn device(&self) -> Result<Stdio> {
        Ok(std::os::fd::OwnedFd::from(self.device.try_clone()?).into())
    }

    /// Sends bytes and returns the line that the board answers.
    pub(super) fn request(&self, bytes: &[u8]) -> Result<String> {
        self.host.write_all(bytes)?;
        let deadline = Instant::now() + TIMEOUT;
        let mut line = Vec::new();
        while !line.ends_with(b"\n") {
            let mut byte = [0];
            match self.host.read(&mut byte) {
                Ok(_) => line.extend(byte),
                Err(error) if error.kind() == std::io::ErrorKind::TimedOut => {}
                Err(error) => return Err(error.into()),
            }
            if Instant::now() > deadline {
                bail!("the board did not answer: {}", line.escape_ascii());
            }
        }
        Ok(String::from_utf8(line)?.trim_end().to_owned())
    }
}
