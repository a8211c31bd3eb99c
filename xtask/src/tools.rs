//! Installs programs that the tests need.

use std::env;

use anyhow::{Context, Result, bail};

use crate::command::{cargo, command, run, works};
use crate::qemu::QEMU;

/// Commands that succeed if a program is installed, and Debian packages that have the program.
const PROGRAMS: [([&str; 2], &[&str]); 3] = [
    ([QEMU, "--version"], &["qemu-system-arm"]),
    (["sdl2-config", "--version"], &["libsdl2-dev"]),
    (["xvfb-run", "--help"], &["xvfb", "xauth"]),
];

/// Installs the programs that `cargo xtask test` needs; rust-toolchain.toml lists the targets and
/// components. Returns an error with the command to run if that is impossible.
pub(crate) fn install() -> Result<()> {
    let mut programs = PROGRAMS.iter();
    programs.try_for_each(|(program, packages)| install_program(*program, packages))
}

/// Installs npm if missing. Only the Raspberry Pi Pico's emulator needs it.
pub(crate) fn install_npm() -> Result<()> {
    install_program(["npm", "--version"], &["nodejs", "npm"])
}

/// Installs flip-link if missing: the linker of boards, which places the stack below the statics.
pub(crate) fn install_flip_link() -> Result<()> {
    let path = env::var_os("PATH").unwrap_or_default();
    let name = format!("flip-link{}", env::consts::EXE_SUFFIX);
    if env::split_paths(&path).any(|folder| folder.join(&name).is_file()) {
        return Ok(());
    }
    run(cargo().args(["install", "--quiet", "--locked", "flip-link"]))
        .context("flip-link is missing; run `cargo install --locked flip-link`")
}

/// Returns an error with the command to run unless a program answers to `--version`.
pub(crate) fn require(program: &[&str], install: &str) -> Result<()> {
    let [name, arguments @ ..] = program else {
        return Ok(());
    };
    if works(command(name).args(arguments).arg("--version")) {
        return Ok(());
    }
    bail!("{} is missing; run `{install}`", program.join(" "))
}

/// Installs the packages as root on Debian. Elsewhere returns an error with their names.
fn install_program([program, argument]: [&str; 2], packages: &[&str]) -> Result<()> {
    if works(command(program).arg(argument)) {
        return Ok(());
    }
    if !is_root() || !works(command("apt-get").arg("--version")) {
        let packages = packages.join(" ");
        bail!("{program} is missing; on Debian, run `sudo apt-get install {packages}`");
    }
    run(command("apt-get").args(["--quiet", "update"]))?;
    let mut install = command("apt-get");
    install.args(["--quiet", "--yes", "--no-install-recommends", "install"]);
    install.env("DEBIAN_FRONTEND", "noninteractive");
    run(install.args(packages))
}

fn is_root() -> bool {
    let output = command("id").arg("-u").output();
    output.is_ok_and(|output| output.stdout.trim_ascii() == b"0")
}
