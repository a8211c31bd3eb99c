//! The tools that the tests need, installed where that is possible.

use std::env;
use std::path::Path;

use anyhow::{Context, Result, bail};

use crate::command::{cargo, command, run, works};
use crate::firmware::TARGETS;
use crate::qemu::QEMU;

/// Installs what is missing; fails with the command that would, where it cannot.
pub(crate) fn install() -> Result<()> {
    TARGETS.into_iter().try_for_each(target)?;
    for (subcommand, component) in [("clippy", "clippy"), ("fmt", "rustfmt")] {
        if !works(cargo().args([subcommand, "--version"])) {
            rustup(&["component", "add", component])?;
        }
    }
    PACKAGES.iter().try_for_each(Package::install_if_missing)
}

/// Installs Node's package manager, if it is missing.
pub(crate) fn install_npm() -> Result<()> {
    NPM.install_if_missing()
}

/// Installs the standard library for a target, if it is missing.
pub(crate) fn target(target: &str) -> Result<()> {
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

/// The linker of firmware whose stack must not grow into its statics.
pub(crate) fn install_flip_link() -> Result<()> {
    let path = env::var_os("PATH").unwrap_or_default();
    let name = format!("flip-link{}", env::consts::EXE_SUFFIX);
    if env::split_paths(&path).any(|folder| folder.join(&name).is_file()) {
        return Ok(());
    }
    run(cargo().args(["install", "--quiet", "--locked", "flip-link"]))
        .context("missing; to install it: cargo install --locked flip-link")
}

fn rustup(arguments: &[&str]) -> Result<()> {
    run(command("rustup").args(arguments))
        .with_context(|| format!("missing; to install it: rustup {}", arguments.join(" ")))
}

/// What the system's package manager has.
struct Package {
    /// Runs with this argument where the package is installed.
    program: &'static str,
    argument: &'static str,
    apt: &'static [&'static str],
    dnf: &'static str,
    pacman: &'static str,
    brew: &'static str,
}

const PACKAGES: [Package; 3] = [
    Package {
        program: QEMU,
        argument: "--version",
        apt: &["qemu-system-arm"],
        dnf: "qemu-system-arm",
        pacman: "qemu-system-arm",
        brew: "qemu",
    },
    Package {
        program: "sdl2-config",
        argument: "--version",
        apt: &["libsdl2-dev"],
        dnf: "SDL2-devel",
        pacman: "sdl2",
        brew: "sdl2",
    },
    Package {
        program: "xvfb-run",
        argument: "--help",
        apt: &["xvfb", "xauth"],
        dnf: "xorg-x11-server-Xvfb",
        pacman: "xorg-server-xvfb",
        brew: "--cask xquartz",
    },
];

/// Needed by the emulator of the Raspberry Pi Pico alone.
const NPM: Package = Package {
    program: "npm",
    argument: "--version",
    apt: &["nodejs", "npm"],
    dnf: "nodejs-npm",
    pacman: "nodejs npm",
    brew: "node",
};

impl Package {
    fn install_if_missing(&self) -> Result<()> {
        if works(command(self.program).arg(self.argument)) {
            return Ok(());
        }
        self.install()
    }

    fn install(&self) -> Result<()> {
        if is_root() && works(command("apt-get").arg("--version")) {
            run(command("apt-get").args(["--quiet", "update"]))?;
            let mut install = command("apt-get");
            install.args(["--quiet", "--yes", "--no-install-recommends", "install"]);
            install.env("DEBIAN_FRONTEND", "noninteractive");
            return run(install.args(self.apt));
        }
        let installers = [
            ("apt-get", "sudo apt-get install", &*self.apt.join(" ")),
            ("dnf", "sudo dnf install", self.dnf),
            ("pacman", "sudo pacman -S", self.pacman),
            ("brew", "brew install", self.brew),
        ];
        let found = installers
            .iter()
            .find(|(program, ..)| works(command(program).arg("--version")));
        match found {
            Some((_, how, name)) => {
                bail!("{} is missing; to install it: {how} {name}", self.program)
            }
            None => bail!(
                "{} is missing, and no package manager is known",
                self.program
            ),
        }
    }
}

fn is_root() -> bool {
    let output = command("id").arg("-u").output();
    output.is_ok_and(|output| output.stdout.trim_ascii() == b"0")
}
