//! Building the firmware, which is in a workspace of its own.

use std::env;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::command::{cargo, run};
use crate::{root, size, target_dir, tools};

/// The firmware as it is flashed, with these scenes or, if
/// none are given, those that it has by default: an ELF file.
pub(super) fn build(scenes: &[&Path]) -> Result<PathBuf> {
    tools::install_flip_link()?;
    let mut build = in_its_folder("build");
    build.args(["--release", "--quiet", "--locked"]);
    if !scenes.is_empty() {
        build.env("SCENE", env::join_paths(scenes)?);
    }
    run(&mut build)?;
    Ok(target_dir().join("thumbv6m-none-eabi/release/pico"))
}

/// Formatting, and what Clippy says.
pub(super) fn lint() -> Result<()> {
    run(in_its_folder("fmt").arg("--check"))?;
    let mut clippy = in_its_folder("clippy");
    clippy.args(["--release", "--quiet", "--locked", "--", "-D", "warnings"]);
    run(&mut clippy)
}

/// The file that a Pico takes by drag and drop.
pub(super) fn uf2(elf: &Path) -> Result<PathBuf> {
    let file = elf.with_extension("uf2");
    let mut convert = Command::new("elf2uf2-rs");
    run(convert.arg(elf).arg(&file))
        .context("to install it: cargo install --locked elf2uf2-rs --no-default-features")?;
    Ok(file)
}

/// Prints the flash that it takes, and the RAM without the stack.
pub(super) fn print_size(elf: &Path) -> Result<()> {
    let usage = size::usage(elf)?;
    println!("flash: {}\nstatics: {}", usage.flash, usage.ram);
    Ok(())
}

/// Cargo there, as only that finds the folder's configuration.
fn in_its_folder(subcommand: &str) -> Command {
    let mut cargo = cargo();
    cargo.current_dir(root().join("boards/pico"));
    cargo.env("CARGO_TARGET_DIR", target_dir());
    cargo.arg(subcommand);
    cargo
}
