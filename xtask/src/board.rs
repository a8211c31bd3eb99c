//! Builds the firmware of the boards in the folder `boards`. The firmware of each board is a
//! separate workspace with its own memory map and Cargo configuration.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use anyhow::{Result, bail};

use crate::command::cargo;
use crate::firmware::{PROFILE, V6M, V7EM, V8M, build_copy};
use crate::size::{Usage, usage};
use crate::{root, target_dir, tools};

/// Target triple of the ESP32-C3.
pub(crate) const RISCV: &str = "riscv32imc-unknown-none-elf";

/// A board with its own workspace in the folder `boards`.
#[derive(Clone, Copy, Debug)]
pub struct Board {
    /// Name of both the folder and the program.
    pub name: &'static str,
    target: &'static str,
    features: &'static str,
    /// Largest allowed flash size in bytes.
    flash: u64,
}

/// STM32F405 with an ILI9341 display.
pub const STM32F405: Board = board("stm32f405", V7EM, 88_000);

/// The STM32F405 firmware with the changes that QEMU needs.
pub const STM32F405_IN_QEMU: Board = Board {
    features: "emulator",
    ..STM32F405
};

/// Raspberry Pi Pico with an ST7789 display. Its firmware also runs unmodified in the emulator
/// rp2040js.
pub const PICO: Board = board("pico", V6M, 121_000);

/// Lists all boards, with the features for real hardware. For the last four boards, the firmware
/// does not run in any emulator.
const ALL: [Board; 6] = [
    STM32F405,
    PICO,
    board("rp2350", V8M, 80_000),
    board("nrf52840", V7EM, 85_000),
    board("esp32c3", RISCV, 141_000),
    board("template", V7EM, 84_000),
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

/// Builds the firmware of all boards. Returns the name of each board with its flash and RAM.
pub(crate) fn flash() -> Result<Vec<(&'static str, Usage)>> {
    let usage = |board: Board| Ok((board.name, usage(&board.build(None)?)?));
    ALL.into_iter().map(usage).collect()
}

/// Builds the firmware of all boards and prints the flash sizes. Returns an error if a board's
/// firmware takes more flash than its budget allows.
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

/// Starts to build the firmware of all boards in the background, while other steps run.
pub(crate) fn start_builds() -> Result<()> {
    // Errors are ignored, because the step that needs the firmware builds it again and reports the
    // error.
    thread::spawn(|| {
        ALL.into_iter()
            .try_for_each(|board| board.build(None).map(drop))
    });
    Ok(())
}

impl Board {
    /// Returns the board's folder.
    pub(crate) fn folder(self) -> PathBuf {
        root().join("boards").join(self.name)
    }

    /// Returns a Cargo command that runs in the board's folder.
    ///
    /// The command uses the target folder of the root workspace and the name of its profile for
    /// firmware. The boards then share built dependencies with each other and with the firmware of
    /// the root workspace.
    pub(crate) fn cargo(self, subcommand: &str) -> Command {
        let mut cargo = cargo();
        cargo.current_dir(self.folder());
        cargo.env("CARGO_TARGET_DIR", target_dir());
        cargo.args([subcommand, "--quiet", "--locked", "--profile", PROFILE]);
        cargo.args(["--config", "profile.firmware.inherits=\"release\""]);
        cargo
    }

    /// Builds the firmware. If `scene` is given, it replaces the default scene. Copies the program,
    /// so that later builds do not overwrite it, and returns the path of the copy.
    pub fn build(self, scene: Option<&Path>) -> Result<PathBuf> {
        tools::install_flip_link()?;
        let mut build = self.cargo("build");
        build.args(["--features", self.features]);
        let program = target_dir().join(self.target).join(PROFILE).join(self.name);
        let name = format!("{}{}", self.name, self.features);
        build_copy(build, scene, &program, &name)
    }
}
