//! The board with the OLED, in QEMU: what it shows, and its buttons.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::{env, fs, process};

use anyhow::Result;

use crate::command::run;
use crate::qemu::{Running, firmware_in};
use crate::qmp::Monitor;
use crate::report::Report;

const MACHINE: &str = "lm3s6965evb";

/// A board that runs.
pub struct Oled {
    running: Running,
    monitor: Monitor,
    socket: PathBuf,
    /// The buttons that were let go at least once.
    let_go: Vec<Button>,
}

/// A button of the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// The camera rises.
    Up,
    /// The camera sinks.
    Down,
    /// The camera goes to its left.
    Left,
    /// The camera goes to its right.
    Right,
    /// The next scene.
    Select,
}

impl Button {
    /// The key that QEMU has for it.
    fn key(self) -> &'static str {
        match self {
            Self::Up => "up",
            Self::Down => "down",
            Self::Left => "left",
            Self::Right => "right",
            Self::Select => "ctrl",
        }
    }
}

impl Oled {
    /// Starts the firmware, and waits until its first picture is complete.
    pub fn start(elf: &Path) -> Result<(Self, Report)> {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        // Not in the target directory, as a socket's path must be short.
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let socket = env::temp_dir().join(format!("whitted-{}-{count}.qmp", process::id()));

        let mut qemu = firmware_in(MACHINE, elf);
        qemu.args(["-display", "none", "-serial", "stdio", "-qmp"]);
        qemu.arg(format!("unix:{},server=on,wait=off", socket.display()));
        let mut running = Running::start(qemu)?;
        let report = running.report()?;
        let monitor = Monitor::connect(&socket)?;
        let oled = Self {
            running,
            monitor,
            socket,
            let_go: Vec::new(),
        };
        Ok((oled, report))
    }

    /// Writes what it shows to a file: PNG by its name, else PPM.
    pub fn screenshot(&mut self, file: &Path) -> Result<()> {
        self.monitor.screendump(file)
    }

    /// Presses buttons, all at once, until the next picture is complete. In QEMU a
    /// button is down until it is let go for the first time, which the firmware
    /// takes for a press.
    pub fn press(&mut self, buttons: &[Button]) -> Result<Report> {
        let keys: Vec<_> = buttons.iter().map(|button| button.key()).collect();
        self.monitor.send_keys(&keys, true)?;
        if buttons.iter().all(|button| self.let_go.contains(button)) {
            let report = self.running.report()?;
            self.monitor.send_keys(&keys, false)?;
            return Ok(report);
        }
        self.monitor.send_keys(&keys, false)?;
        self.let_go.extend(buttons);
        self.running.report()
    }
}

impl Drop for Oled {
    fn drop(&mut self) {
        _ = fs::remove_file(&self.socket);
    }
}

/// Runs firmware until its first picture is complete.
pub fn draw(elf: &Path, screenshot: Option<&Path>) -> Result<Report> {
    let (mut oled, report) = Oled::start(elf)?;
    if let Some(file) = screenshot {
        oled.screenshot(file)?;
    }
    Ok(report)
}

/// Runs firmware with the display in a window, until a person closes it. The
/// arrow keys and the left Ctrl key are the board's buttons.
pub fn show(elf: &Path) -> Result<()> {
    run(firmware_in(MACHINE, elf).args(["-serial", "stdio"]))
}
