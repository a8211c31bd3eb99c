//! Building the firmware.

use std::env;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use crate::board::PICO;
use crate::command::{command, run};
use crate::size;

/// The firmware as it is flashed, with these scenes or, if none are given, those
/// that it has by default: an ELF file.
pub(super) fn build(scenes: &[&Path]) -> Result<PathBuf> {
    if scenes.is_empty() {
        return PICO.build(None);
    }
    let list = env::join_paths(scenes)?;
    PICO.build(Some(Path::new(&list)))
}

/// What Clippy says.
pub(super) fn lint() -> Result<()> {
    let mut clippy = PICO.cargo("clippy");
    clippy.args(["--release", "--quiet", "--locked", "--", "-D", "warnings"]);
    run(&mut clippy)
}

/// The file that a Pico takes by drag and drop.
pub(super) fn uf2(elf: &Path) -> Result<PathBuf> {
    let file = elf.with_extension("uf2");
    run(command("elf2uf2-rs").arg(elf).arg(&file))
        .context("to install it: cargo install --locked elf2uf2-rs --no-default-features")?;
    Ok(file)
}

/// Prints the flash that it takes, and the RAM without the stack.
pub(super) fn print_size(elf: &Path) -> Result<()> {
    let usage = size::usage(elf)?;
    println!("flash: {}\nstatics: {}", usage.flash, usage.ram);
    Ok(())
}
