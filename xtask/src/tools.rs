//! The tools that the tests need, installed where that is possible.

use std::path::Path;

use anyhow::{Context, Result, bail};

use crate::command::{cargo, command, run, works};
use crate::firmware::TARGETS;
use crate::qemu::QEMU;

/// Installs what is missing; fails with the command that would, where it cannot.
pub(crate) fn install() -> Result<()> {
    TARGETS.into_iter().try_for_each(add_target)?;
    for (subcommand, component) in [("clippy", "clippy"), ("fmt", "rustfmt")] {
        if !works(cargo().args([subcommand, "--version"])) {
            rustup(&["component", "add", component])?;
        }
    }
    if !works(command(QEMU).arg("--version")) {
        qemu()?;
    }
    Ok(())
}

/// Installs the standard library for the target, if it is missing.
pub(crate) fn add_target(target: &str) -> Result<()> {
    if has_target(target) {
        return Ok(());
    }
    rustup(&["target", "add", target])
}

/// Whether the standard library for the target is there, whoever put it there.
fn has_target(target: &str) -> bool {
    let output = command("rustc")
        .args(["--print", "target-libdir", "--target", target])
        .output();
    output.is_ok_and(|output| {
        let folder = String::from_utf8_lossy(&output.stdout);
        output.status.success() && Path::new(folder.trim()).is_dir()
    })
}

fn rustup(arguments: &[&str]) -> Result<()> {
    run(command("rustup").args(arguments))
        .with_context(|| format!("missing; to install it: rustup {}", arguments.join(" ")))
}

fn qemu() -> Result<()> {
    if is_root() && works(command("apt-get").arg("--version")) {
        run(command("apt-get").args(["--quiet", "update"]))?;
        let mut install = command("apt-get");
        install.args([
            "--quiet",
            "--yes",
            "--no-install-recommends",
            "install",
            "qemu-system-arm",
        ]);
        return run(install.env("DEBIAN_FRONTEND", "noninteractive"));
    }
    let installers = [
        ("apt-get", "sudo apt-get install qemu-system-arm"),
        ("dnf", "sudo dnf install qemu-system-arm"),
        ("pacman", "sudo pacman -S qemu-system-arm"),
        ("brew", "brew install qemu"),
    ];
    let found = installers
        .iter()
        .find(|(program, _)| works(command(program).arg("--version")));
    let how = found.map_or("see https://www.qemu.org/download/", |(_, how)| how);
    bail!("{QEMU} is missing; to install it: {how}")
}

fn is_root() -> bool {
    let output = command("id").arg("-u").output();
    output.is_ok_and(|output| output.stdout.trim_ascii() == b"0")
}
