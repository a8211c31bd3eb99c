//! Boards that are workspaces of their own, with their own memory map and Cargo configuration.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use anyhow::{Result, bail};

use crate::command::cargo;
use crate::firmware::{V6M, V7EM, V8M, build_copy};
use crate::size::{Usage, usage};
use crate::{root, target_dir, tools};

/// Target of the ESP32-C3.
pub(crate) const RISCV: &str = "riscv32imc-unknown-none-elf";

/// A package in a folder of `boards`.
#[derive(Clone, Copy, Debug)]
pub struct Board {
    /// Name of the folder and the program.
    pub name: &'static str,
    target: &'static str,
    features: &'static str,
    /// Flash budget in bytes.
    flash: u64,
}

/// STM32F405 with an ILI9341 display.
pub const STM32F405: Board = board("stm32f405", V7EM, 88_000);

/// The STM32F405 firmware with the changes that QEMU needs.
pub const STM32F405_IN_QEMU: Board = Board {
    features: "emulator",
    ..STM32F405
};

/// Raspberry Pi Pico with an ST7789 display. rp2040js runs the unmodified firmware.
pub const PICO: Board = board("pico", V6M, 121_000);

/// All boards, as they run on hardware. No emulator runs the last three.
const ALL: [Board; 5] = [
    STM32F405,
    PICO,
    board("rp2350", V8M, 80_000),
    board("nrf52840", V7EM, 85_000),
    board("esp32c3", RISCV, 140_000),
];

const fn board(name: &'static str, target: &'static str, flash: u64) -> Board {
    Board {
        name,
        target,
        features: "",
        flash,
    }
}

/// Returns the folders of all boards.
pub(crate) fn folders() -> impl Iterator<Item = PathBuf> {
    ALL.into_iter().map(Board::folder)
}

/// Builds all boards and returns names, flash and RAM.
pub(crate) fn flash() -> Result<Vec<(&'static str, Usage)>> {
    let usage = |board: Board| Ok((board.name, usage(&board.build(None)?)?));
    ALL.into_iter().map(usage).collect()
}

/// Builds all boards and prints their flash. Returns an error if one is over its budget.
pub fn build_all() -> Result<()> {
    println!("{:12} {:>7} {:>7}", "board", "flash", "budget");
    let mut too_large = Vec::new();
    for (board, (_, Usage { flash, .. })) in ALL.into_iter().zip(flash()?) {
        println!("{:12} {flash:7} {:7}", board.name, board.flash);
        if flash > board.flash {
            too_large.push(board.name);
        }
    }
    if !too_large.is_empty() {
        bail!("over the flash budget: {}", too_large.join(", "));
    }
    Ok(())
}

/// Starts to build all boards in the background, to use cores that other steps leave idle.
pub(crate) fn start_builds() -> Result<()> {
    // A failed build fails again in the step that needs it.
    thread::spawn(|| {
        ALL.into_iter()
            .try_for_each(|board| board.build(None).map(drop))
    });
    Ok(())
}

/// Returns the target folder of all boards, which share dependencies.
fn builds() -> PathBuf {
    target_dir().join("boards")
}

impl Board {
    /// Returns the board's folder.
    pub(crate) fn folder(self) -> PathBuf {
        root().join("boards").join(self.name)
    }

    /// Returns a Cargo command that runs in the board's folder.
    pub(crate) fn cargo(self, subcommand: &str) -> Command {
        let mut cargo = cargo();
        cargo.current_dir(self.folder());
        cargo.env("CARGO_TARGET_DIR", builds());
        cargo.arg(subcommand);
        cargo
    }

    /// Builds the firmware and returns the path of a copy that later builds do not overwrite.
    /// `scene` replaces the default scene.
    pub fn build(self, scene: Option<&Path>) -> Result<PathBuf> {
        tools::install_flip_link()?;
        let mut build = self.cargo("build");
        build.args(["--quiet", "--release", "--locked"]);
        build.args(["--features", self.features]);
        let program = builds().join(self.target).join("release").join(self.name);
        let name = format!("{}{}", self.name, self.features);
        build_copy(build, scene, &program, &name)
    }
}
