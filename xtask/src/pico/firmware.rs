use std::env;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

use crate::board::PICO;
use crate::command::{command, run};
use crate::size;

/// Builds the firmware with these scenes, or with the default scenes if the list is empty.
pub(super) fn build(scenes: &[&Path]) -> Result<PathBuf> {
    if scenes.is_empty() {
        return PICO.build(None);
    }
    let list = env::join_paths(scenes)?;
    PICO.build(Some(Path::new(&list)))
}

/// Runs Clippy.
pub(super) fn lint() -> Result<()> {
    let mut clippy = PICO.cargo("clippy");
    clippy.args(["--release", "--quiet", "--locked", "--", "-D", "warnings"]);
    run(&mut clippy)
}

/// Converts an ELF file to UF2 and returns the path.
pub(super) fn uf2(elf: &Path) -> Result<PathBuf> {
    let file = elf.with_extension("uf2");
    run(command("elf2uf2-rs").arg(elf).arg(&file))
        .context("run `cargo install --locked elf2uf2-rs --no-default-features`")?;
    Ok(file)
}

/// Prints flash and static RAM.
pub(super) fn print_size(elf: &Path) -> Result<()> {
    let usage = size::usage(elf)?;
    println!("flash: {}\nstatics: {}", usage.flash, usage.ram);
    Ok(())
}
