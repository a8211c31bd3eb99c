//! Firmware outside of the workspace: each with its own memory, dependencies and
//! settings of Cargo.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;
use std::thread;

use anyhow::{Context, Result, bail};

use crate::command::{cargo, run};
use crate::firmware::{V6M, V7EM, V8M};
use crate::size::usage;
use crate::{root, scratch_dir, target_dir, tools};

/// Instructions of the ESP32-C3.
pub(crate) const RISCV: &str = "riscv32imc-unknown-none-elf";

/// A package in a folder of `boards` that is a workspace of its own.
#[derive(Clone, Copy, Debug)]
pub struct Board {
    /// The folder, and the program.
    pub name: &'static str,
    target: &'static str,
    /// Features of the package, or nothing.
    features: &'static str,
    /// The most bytes of flash that it may take.
    flash: u64,
}

/// The STM32F405 with an ILI9341.
pub const STM32F405: Board = Board {
    name: "stm32f405",
    target: V7EM,
    features: "",
    flash: 88_000,
};

/// The same for QEMU.
pub const STM32F405_IN_QEMU: Board = Board {
    features: "emulator",
    ..STM32F405
};

/// The Raspberry Pi Pico with an ST7789, which rp2040js runs as it is.
pub const PICO: Board = Board {
    name: "pico",
    target: V6M,
    features: "",
    flash: 121_000,
};

/// Those that no emulator runs.
pub const BUILT_ONLY: [Board; 3] = [
    Board {
        name: "rp2350",
        target: V8M,
        features: "",
        flash: 80_000,
    },
    Board {
        name: "nrf52840",
        target: V7EM,
        features: "",
        flash: 85_000,
    },
    Board {
        name: "esp32c3",
        target: RISCV,
        features: "",
        flash: 140_000,
    },
];

/// All of them, as they are on hardware.
pub(crate) fn all() -> impl Iterator<Item = Board> {
    [STM32F405, PICO].into_iter().chain(BUILT_ONLY)
}

/// Builds all, prints what they take, and fails where that is over the budget.
pub fn build_all() -> Result<()> {
    println!("{:12} {:>7} {:>7}", "board", "flash", "budget");
    let mut too_large = Vec::new();
    for board in all() {
        let flash = usage(&board.build(None)?)?.flash;
        println!("{:12} {flash:7} {:7}", board.name, board.flash);
        if flash > board.flash {
            too_large.push(board.name);
        }
    }
    if !too_large.is_empty() {
        bail!("more flash than the budget: {}", too_large.join(", "));
    }
    Ok(())
}

/// Begins to build them. Other tasks, which leave cores idle now and then, have
/// nothing to do with what is built here. Whoever builds one after this waits for it.
pub(crate) fn build_ahead() -> Result<()> {
    // If one fails, it fails again where somebody asks for it.
    thread::spawn(|| all().try_for_each(|board| board.build(None).map(drop)));
    Ok(())
}

/// Where all of them are built, so that what they share is built once.
fn built() -> PathBuf {
    target_dir().join("boards")
}

impl Board {
    /// Its folder.
    pub(crate) fn folder(self) -> PathBuf {
        root().join("boards").join(self.name)
    }

    /// Cargo there, as its settings hold in its folder.
    pub(crate) fn cargo(self, subcommand: &str) -> Command {
        let mut cargo = cargo();
        cargo.current_dir(self.folder());
        cargo.env("CARGO_TARGET_DIR", built());
        cargo.arg(subcommand);
        cargo
    }

    /// Builds it, with this scene in flash in place of the default scene, and
    /// returns the program, as a file that a later build does not change.
    pub fn build(self, scene: Option<&Path>) -> Result<PathBuf> {
        // Builds with other scenes or features give a file of the same name.
        static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
        let _guard = ONE_AT_A_TIME.lock();

        tools::target(self.target)?;
        tools::install_flip_link()?;
        let mut build = self.cargo("build");
        build.args(["--quiet", "--release", "--locked"]);
        build.args(["--features", self.features]);
        if let Some(scene) = scene {
            build.env("SCENE", scene);
        }
        run(&mut build)?;

        let program = built().join(self.target).join("release").join(self.name);
        let scene = scene.and_then(Path::file_stem).unwrap_or_default();
        let copy = format!("{}{}-{}.elf", self.name, self.features, scene.display());
        let copy = scratch_dir()?.join(copy);
        fs::copy(&program, &copy)
            .with_context(|| format!("no firmware at {}", program.display()))?;
        Ok(copy)
    }
}
