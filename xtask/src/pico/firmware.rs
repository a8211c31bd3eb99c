use std::env;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use crate::board::PICO;
use crate::command::{command, run};
use crate::size;

/// Builds the firmware with the given scenes, or with the default scenes if the list is empty.
pub(super) fn build(scenes: &[&Path]) -> Result<PathBuf> {
    if scenes.is_empty() {
        return PICO.build(None);
    }
    let list = env::join_paths(scenes)?;
    PICO.build(Some(Path::new(&list)))
}

/// Runs Clippy on the firmware of the Pico.
pub(super) fn lint() -> Result<()> {
    let mut clippy = PICO.cargo("clippy");
    clippy.args(["--", "-D", "warnings"]);
    run(&mut clippy)
}

/// Converts an ELF file to a UF2 file. Returns the path of the UF2 file.
pub(super) fn uf2(elf: &Path) -> Result<PathBuf> {
    let file = elf.with_extension("uf2");
    run(command("elf2uf2-rs").arg(elf).arg(&file))
        .context("run `cargo install --locked elf2uf2-rs --no-default-features`")?;
    Ok(file)
}

/// Prints how much flash and static RAM the firmware in an ELF file takes.
pub(super) fn print_size(elf: &Path) -> Result<()> {
    let usage = size::usage(elf)?;
    println!("flash: {}\nstatics: {}", usage.flash, usage.ram);
    Ok(())
}
