use std::ffi::OsStr;
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::root;

/// Returns a command that runs in the root of the project.
pub(crate) fn command(program: impl AsRef<OsStr>) -> Command {
    let mut command = Command::new(program);
    command.current_dir(root());
    command
}

/// Returns a command for the same Cargo that runs this program.
pub(crate) fn cargo() -> Command {
    command(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// Returns a command that runs Cargo of another toolchain, such as `+nightly`. The command builds
/// in a separate target folder.
pub(crate) fn cargo_of(toolchain: &str, target_dir: &str) -> Command {
    let mut cargo = command("cargo");
    cargo.arg(toolchain);
    cargo.env("CARGO_TARGET_DIR", crate::target_dir().join(target_dir));
    // Cargo started this program with these variables. If they were kept, they would select the
    // toolchain of this program.
    for variable in ["RUSTUP_TOOLCHAIN", "CARGO", "RUSTC"] {
        cargo.env_remove(variable);
    }
    cargo
}

/// Runs a command. Returns an error unless the command succeeds.
pub(crate) fn run(command: &mut Command) -> Result<()> {
    let program = command.get_program().to_owned();
    let status = command
        .status()
        .with_context(|| format!("cannot start {}", program.display()))?;
    if !status.success() {
        bail!("{command:?} failed: {status}");
    }
    Ok(())
}

/// Returns true if a command succeeds. Hides its output.
pub(crate) fn works(command: &mut Command) -> bool {
    command.output().is_ok_and(|output| output.status.success())
}
