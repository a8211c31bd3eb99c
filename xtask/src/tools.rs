//! Installs programs that the tests need.

use std::env;

use anyhow::{Context, Result, bail};

use crate::command::{cargo, command, run, works};
use crate::qemu::QEMU;

/// Lists the needed programs. Each entry has a command that succeeds if the program is installed,
/// and the Debian packages to install otherwise.
const PROGRAMS: [([&str; 2], &[&str]); 3] = [
    ([QEMU, "--version"], &["qemu-system-arm"]),
    (["sdl2-config", "--version"], &["libsdl2-dev"]),
    (["xvfb-run", "--help"], &["xvfb", "xauth"]),
];

/// Installs the programs that `cargo xtask test` needs. If it cannot install a program, returns an
/// error with the command to run. Does not install Rust targets and components, because rustup
/// installs those that are listed in rust-toolchain.toml.
pub(crate) fn install() -> Result<()> {
    let mut programs = PROGRAMS.iter();
    programs.try_for_each(|(program, packages)| install_program(*program, packages))
}

/// Installs npm if it is missing. Only the Raspberry Pi Pico's emulator needs npm.
pub(crate) fn install_npm() -> Result<()> {
    install_program(["npm", "--version"], &["nodejs", "npm"])
}

/// Installs the linker flip-link if it is missing. Boards use it to place the stack below the
/// statics.
pub(crate) fn install_flip_link() -> Result<()> {
    let path = env::var_os("PATH").unwrap_or_default();
    let name = format!("flip-link{}", env::consts::EXE_SUFFIX);
    if env::split_paths(&path).any(|folder| folder.join(&name).is_file()) {
        return Ok(());
    }
    run(cargo().args(["install", "--quiet", "--locked", "flip-link"]))
        .context("flip-link is missing; run `cargo install --locked flip-link`")
}

/// Runs a program with `--version` to check that it is installed. If the program is missing,
/// returns an error with the command that installs it.
pub(crate) fn require(program: &[&str], install: &str) -> Result<()> {
    let [name, arguments @ ..] = program else {
        return Ok(());
    };
    if works(command(name).args(arguments).arg("--version")) {
        return Ok(());
    }
    bail!("{} is missing; run `{install}`", program.join(" "))
}

/// Installs the packages of a program if the program is missing. This is only possible if the
/// process runs as root on Debian. Otherwise, returns an error with the names of the packages.
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
