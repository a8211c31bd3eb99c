//! Runs the LM3S6965 board in QEMU, with its OLED display and its buttons.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::{env, fs, process};

use anyhow::Result;

use crate::command;
use crate::firmware::LM3S6965EVB;
use crate::qemu::{Running, firmware_in};
use crate::qmp::Monitor;
use crate::report::Report;

const MACHINE: &str = "lm3s6965evb";

/// An LM3S6965 board that runs in QEMU.
pub struct Oled {
    running: Running,
    monitor: Monitor,
    socket: PathBuf,
    /// Buttons that were released at least once since the start.
    released: Vec<Button>,
}

/// A button of the board.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// Moves the camera up.
    Up,
    /// Moves the camera down.
    Down,
    /// Moves the camera left.
    Left,
    /// Moves the camera right.
    Right,
    /// Shows the next scene.
    Select,
}

impl Button {
    /// Returns QEMU's key for the button.
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
    /// Starts the firmware and waits for its first picture.
    pub fn start(elf: &Path) -> Result<(Self, Report)> {
        static COUNT: AtomicU32 = AtomicU32::new(0);
        // The path of a socket must be shorter than about 100 bytes. The path of the target folder
        // may be too long, so the socket is in the temporary folder.
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
            released: Vec::new(),
        };
        Ok((oled, report))
    }

    /// Writes a screenshot: a PNG if the file name ends in `.png`, else a PPM.
    pub fn screenshot(&mut self, file: &Path) -> Result<()> {
        self.monitor.screendump(file)
    }

    /// Presses several buttons at once and waits for the next picture.
    ///
    /// QEMU starts with all buttons down. Therefore, the firmware sees the first press of a button
    /// only when the button is released.
    pub fn press(&mut self, buttons: &[Button]) -> Result<Report> {
        let keys: Vec<_> = buttons.iter().map(|button| button.key()).collect();
        self.monitor.send_keys(&keys, true)?;
        if buttons.iter().all(|button| self.released.contains(button)) {
            let report = self.running.report()?;
            self.monitor.send_keys(&keys, false)?;
            return Ok(report);
        }
        self.monitor.send_keys(&keys, false)?;
        self.released.extend(buttons);
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

/// Draws a scene, or the firmware's own scenes if `scene` is `None`. If `window` is true, shows the
/// display in a window until QEMU exits. Otherwise, stops after the first picture.
pub fn run(scene: Option<&Path>, screenshot: Option<&Path>, window: bool) -> Result<()> {
    let elf = LM3S6965EVB.build(scene)?;
    if window {
        return command::run(firmware_in(MACHINE, &elf).args(["-serial", "stdio"]));
    }
    let report = draw(&elf, screenshot)?;
    print!("{report}");
    report.result().map(drop)
}
