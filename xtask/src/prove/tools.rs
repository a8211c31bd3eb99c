//! What the tests do not need, but proofs do.

use anyhow::{Result, bail};

use crate::command::{cargo, command, works};
pub(super) use crate::tools::target;

pub(super) const MIPS: &str = "mips-unknown-linux-gnu";
pub(super) const WASM: &str = "wasm32-unknown-unknown";
pub(super) const RISCV: &str = "riscv32imc-unknown-none-elf";

/// The toolchain of cargo-fuzz and Miri.
pub(super) const NIGHTLY: &str = "+nightly";
/// The oldest one that Cargo.toml promises.
pub(super) const OLDEST: &str = "+1.89";

/// A program that is there, or an error that says how to install it.
pub(super) fn program(name: &str, how: &str) -> Result<()> {
    if works(command(name).arg("--version")) {
        return Ok(());
    }
    bail!("{name} is missing; to install it: {how}")
}

/// The same of a subcommand of Cargo.
pub(super) fn subcommand(name: &str) -> Result<()> {
    if works(cargo().args([name, "--version"])) {
        return Ok(());
    }
    bail!("cargo-{name} is missing; to install it: cargo install cargo-{name}")
}

/// The same of a toolchain.
pub(super) fn toolchain(name: &str, how: &str) -> Result<()> {
    if works(command("cargo").args([name, "--version"])) {
        return Ok(());
    }
    bail!("a toolchain is missing; to install it: rustup {how}")
}
