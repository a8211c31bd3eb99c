//! Running firmware in QEMU.

use std::io::{self, BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::str::FromStr;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};
use std::{fmt, fs, thread};

use anyhow::{Context, Result, bail};

use crate::command::command;
use crate::firmware::{self, Firmware, V6M, V7EM, V7M, V8M};
use crate::report::Report;
use crate::scratch_dir;

/// The program.
pub(crate) const QEMU: &str = "qemu-system-arm";

/// Firmware that takes longer hangs.
const PATIENCE: Duration = Duration::from_secs(300);

/// The line after which a picture is complete.
const END: &str = "end";

/// A core that the headless firmware runs on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Core {
    /// Cortex-M0: its code, on an M3, as QEMU's only M0 has no memory to speak of.
    M0,
    /// Cortex-M3.
    M3,
    /// Cortex-M4 with floats in hardware.
    M4f,
    /// Cortex-M7 with floats in hardware; the M4F's code.
    M7,
    /// Cortex-M33 with floats in hardware.
    M33,
}

impl Core {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::M0, Self::M3, Self::M4f, Self::M7, Self::M33];

    /// Its name for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::M0 => "Cortex-M0+",
            Self::M3 => "Cortex-M3",
            Self::M4f => "Cortex-M4F",
            Self::M7 => "Cortex-M7",
            Self::M33 => "Cortex-M33",
        }
    }

    /// Whether it has floats in hardware.
    pub fn has_fpu(self) -> bool {
        !matches!(self, Self::M0 | Self::M3)
    }
}

impl fmt::Display for Core {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::M0 => "m0",
            Self::M3 => "m3",
            Self::M4f => "m4f",
            Self::M7 => "m7",
            Self::M33 => "m33",
        })
    }
}

impl FromStr for Core {
    type Err = anyhow::Error;

    fn from_str(name: &str) -> Result<Self> {
        let named = Self::ALL.into_iter().find(|core| core.to_string() == name);
        named.with_context(|| {
            format!(
                "no core {name}; there are {}",
                Self::ALL.map(|core| core.to_string()).join(", ")
            )
        })
    }
}

/// A board of QEMU's that draws scenes which the host gives it.
#[derive(Clone, Copy, Debug)]
pub struct Machine {
    name: &'static str,
    target: &'static str,
}

impl Machine {
    /// The one with this core.
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

    /// The firmware that draws frames without end for it.
    pub(crate) fn soak(self) -> Firmware {
        firmware::soak(self.target)
    }

    /// The firmware that draws for it.
    pub fn firmware(self, arithmetic: Arithmetic) -> Firmware {
        match arithmetic {
            Arithmetic::Fixed => firmware::headless(self.target),
            Arithmetic::Float => firmware::float(self.target),
        }
    }

    /// What compares products in assembly with the plain ones.
    pub fn products(self) -> Firmware {
        firmware::products(self.target)
    }

    /// Draws the scene in a file that [`Arithmetic::compile`] has made.
    pub fn draw(self, elf: &Path, scene: &Path, size: &str) -> Result<Report> {
        Running::start(self.drawing(elf, scene, size))?.finish()
    }

    /// Runs firmware that needs nothing of the host.
    pub fn run(self, elf: &Path) -> Result<Report> {
        self.start(elf)?.finish()
    }

    /// The same for firmware that is to be watched.
    pub(crate) fn start(self, elf: &Path) -> Result<Running> {
        let mut qemu = firmware_in(self.name, elf);
        qemu.args(["-display", "none", "-chardev", "stdio,id=host"]);
        qemu.args([
            "-semihosting-config",
            "enable=on,target=native,chardev=host",
        ]);
        Running::start(qemu)
    }

    /// QEMU, about to draw.
    pub(crate) fn drawing(self, elf: &Path, scene: &Path, size: &str) -> Command {
        // A comma ends a value, unless doubled.
        let scene = scene.display().to_string().replace(',', ",,");
        let mut qemu = firmware_in(self.name, elf);
        qemu.args(["-display", "none", "-chardev", "stdio,id=host"]);
        qemu.arg("-semihosting-config");
        qemu.arg(format!(
            "enable=on,target=native,chardev=host,arg={size},arg={scene}"
        ));
        qemu
    }
}

/// What a scene is drawn in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// Fixed point: by the library.
    Fixed,
    /// Floating point: by the yardstick.
    Float,
}

impl Arithmetic {
    /// Compiles a scene file for the firmware, to a file of its name.
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
        fs::write(&file, compiled)?;
        Ok(file)
    }
}

/// QEMU with a clock that counts instructions: each takes a nanosecond.
pub(crate) fn firmware_in(machine: &str, elf: &Path) -> Command {
    let mut qemu = command(QEMU);
    qemu.args(["-machine", machine, "-icount", "shift=0", "-nodefaults"]);
    qemu.arg("-kernel").arg(elf);
    qemu
}

/// A QEMU that ends with this value at the latest.
pub(crate) struct Running {
    qemu: Child,
    /// What it prints.
    lines: Receiver<io::Result<String>>,
}

impl Drop for Running {
    fn drop(&mut self) {
        _ = self.qemu.kill();
        _ = self.qemu.wait();
    }
}

impl Running {
    pub(crate) fn start(mut command: Command) -> Result<Self> {
        command.stdin(Stdio::null());
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut qemu = command
            .spawn()
            .with_context(|| format!("{QEMU} does not start"))?;
        let output = qemu.stdout.take().context("QEMU prints nowhere")?;
        let (sender, lines) = channel();
        // In a thread, as reading has no timeout. It ends with QEMU.
        thread::spawn(move || {
            for line in BufReader::new(output).lines() {
                if line.is_err() || sender.send(line).is_err() {
                    break;
                }
            }
        });
        Ok(Self { qemu, lines })
    }

    /// What the firmware prints until it says that this is the end, or QEMU ends.
    pub(crate) fn report(&mut self) -> Result<Report> {
        let deadline = Instant::now() + PATIENCE;
        let mut lines = Vec::new();
        loop {
            let left = deadline.saturating_duration_since(Instant::now());
            match self.lines.recv_timeout(left) {
                Ok(line) => match line?.trim_end() {
                    END => return Ok(Report::new(lines)),
                    line => lines.push(line.to_owned()),
                },
                Err(RecvTimeoutError::Disconnected) => return Ok(Report::new(lines)),
                Err(RecvTimeoutError::Timeout) => {
                    bail!(
                        "the firmware did not end, it printed:\n{}",
                        Report::new(lines)
                    )
                }
            }
        }
    }

    /// The next line that the firmware prints.
    pub(crate) fn line(&self) -> Result<String> {
        let line = self.lines.recv_timeout(PATIENCE);
        line.context("the firmware prints no more")?
            .context("QEMU's output cannot be read")
    }

    /// The report of firmware that ends QEMU itself.
    fn finish(mut self) -> Result<Report> {
        let report = self.report()?;
        let mut complaints = String::new();
        if let Some(mut errors) = self.qemu.stderr.take() {
            errors.read_to_string(&mut complaints)?;
        }
        let status = self.qemu.wait()?;
        if !status.success() {
            bail!("QEMU failed: {status}\n{complaints}");
        }
        Ok(report)
    }
}
