//! Runs firmware in QEMU.

mod running;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, thread};

use anyhow::Result;

use crate::command::command;
use crate::core::Core;
use crate::firmware::{Firmware, V6M, V7EM, V7M, V8M};
use crate::report::Report;
use crate::scratch_dir;

pub(crate) use running::Running;

/// Name of QEMU's program for Arm.
pub(crate) const QEMU: &str = "qemu-system-arm";

/// A board that QEMU emulates. Its firmware can read files of the host by semihosting.
#[derive(Clone, Copy, Debug)]
pub struct Machine {
    name: &'static str,
    target: &'static str,
}

impl Machine {
    /// Returns the QEMU board that has this core.
    pub fn of(core: Core) -> Self {
        let (name, target) = match core {
            Core::M0 => ("mps2-an385", V6M),
            Core::M3 => ("mps2-an385", V7M),
            Core::M4f => ("mps2-an386", V7EM),
            Core::M7 => ("mps2-an500", V7EM),
            Core::M33 => ("mps2-an505", V8M),
        };
        Self { name, target }
    }

    /// Returns the firmware package with this name in `tests/rigs`, to be built for this board.
    pub fn rig(self, package: &'static str) -> Firmware {
        Firmware::new(package, self.target)
    }

    /// Runs firmware that draws a scene file compiled by [`Arithmetic::compile`].
    pub fn draw(self, elf: &Path, scene: &Path, size: &str) -> Result<Report> {
        Running::start(self.drawing(elf, scene, size))?.finish()
    }

    /// Runs firmware that needs no scene, until QEMU exits.
    pub fn run(self, elf: &Path) -> Result<Report> {
        self.start(elf)?.finish()
    }

    /// Starts firmware that needs no scene.
    pub(crate) fn start(self, elf: &Path) -> Result<Running> {
        Running::start(self.with_host(elf, ""))
    }

    /// Returns the QEMU command that draws a scene.
    pub(crate) fn drawing(self, elf: &Path, scene: &Path, size: &str) -> Command {
        // A comma ends a value in the options of QEMU. Therefore, a comma in a path must be
        // doubled.
        let scene = scene.display().to_string().replace(',', ",,");
        self.with_host(elf, &format!(",arg={size},arg={scene}"))
    }

    /// Returns the QEMU command that runs firmware with semihosting. QEMU passes `arguments` to the
    /// firmware as its command line.
    fn with_host(self, elf: &Path, arguments: &str) -> Command {
        let mut qemu = firmware_in(self.name, elf);
        qemu.args(["-display", "none", "-chardev", "stdio,id=host"]);
        qemu.arg("-semihosting-config");
        qemu.arg(format!("enable=on,target=native,chardev=host{arguments}"));
        qemu
    }
}

/// The arithmetic with which firmware draws a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// Fixed point, as the library computes.
    Fixed,
    /// Single-precision floats. The reference ray tracer in `tests/oracle` computes with them.
    Float,
}

impl Arithmetic {
    /// Returns the name of the package in `tests/rigs` that draws with this arithmetic.
    pub fn rig(self) -> &'static str {
        match self {
            Self::Fixed => "headless",
            Self::Float => "float",
        }
    }

    /// Compiles a scene file for the firmware that draws with this arithmetic. Returns the path of
    /// the compiled scene.
    pub fn compile(self, scene: &Path) -> Result<PathBuf> {
        let (compiled, extension) = match self {
            Self::Fixed => (whitted_sim::scene_file::compile(scene)?, "bin"),
            Self::Float => {
                let scene = whitted_oracle::load::<f32>(scene);
                (postcard::to_stdvec(&scene.scene())?, "float.bin")
            }
        };
        let name = scene.file_name().unwrap_or_default();
        let file = scratch_dir()?.join(name).with_extension(extension);
        // Another thread may still read the file of an earlier call. Therefore, the scene is first
        // written to a temporary file, which then replaces the earlier file in one operation.
        let temporary = file.with_extension(format!("{:?}", thread::current().id()));
        fs::write(&temporary, compiled)?;
        fs::rename(&temporary, &file)?;
        Ok(file)
    }
}

/// Returns a QEMU command that runs firmware. Each instruction advances the emulated clock by one
/// nanosecond.
pub(crate) fn firmware_in(machine: &str, elf: &Path) -> Command {
    let mut qemu = command(QEMU);
    qemu.args(["-machine", machine, "-icount", "shift=0", "-nodefaults"]);
    qemu.arg("-kernel").arg(elf);
    qemu
}
