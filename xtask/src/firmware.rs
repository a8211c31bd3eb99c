//! Builds the firmware packages in the root workspace.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

use anyhow::{Context, Result};

use crate::command::{cargo, run};
use crate::{scratch_dir, target_dir};

/// Target triple of the Cortex-M0 and M0+.
pub const V6M: &str = "thumbv6m-none-eabi";
/// Target triple of the Cortex-M3.
pub const V7M: &str = "thumbv7m-none-eabi";
/// Target triple of the Cortex-M4F and M7, with an FPU.
pub const V7EM: &str = "thumbv7em-none-eabihf";
/// Target triple of the Cortex-M33, with an FPU.
pub const V8M: &str = "thumbv8m.main-none-eabihf";

/// Target triples of all Cortex-M firmware.
pub const TARGETS: [&str; 4] = [V6M, V7M, V7EM, V8M];

/// Name of the Cargo profile for microcontrollers in the root Cargo.toml.
pub(crate) const PROFILE: &str = "firmware";

/// A firmware package of the root workspace, and the target for which it is built.
#[derive(Clone, Copy, Debug)]
pub struct Firmware {
    /// Name of the package.
    pub package: &'static str,
    /// Name of the program.
    pub program: &'static str,
    /// Target triple.
    pub target: &'static str,
    /// True if the package is built with its default features.
    pub defaults: bool,
}

/// The LM3S6965 board with an OLED display.
pub const LM3S6965EVB: Firmware = Firmware::new("lm3s6965evb", V7M);

impl Firmware {
    /// Creates the value for a package with its default features. The program has the name of the
    /// package.
    pub const fn new(package: &'static str, target: &'static str) -> Self {
        Self {
            package,
            program: package,
            target,
            defaults: true,
        }
    }

    /// Builds the firmware. If the firmware has a scene in flash, `scene` replaces its default
    /// scene. Copies the program, so that later builds do not overwrite it, and returns the path of
    /// the copy.
    pub fn build(self, scene: Option<&Path>) -> Result<PathBuf> {
        let Self {
            package,
            program,
            target,
            defaults,
        } = self;
        let mut build = cargo();
        build.args(["build", "--quiet", "--profile", PROFILE]);
        build.args(["--package", package, "--bin", program, "--target", target]);
        if !defaults {
            build.arg("--no-default-features");
        }
        let variant = if defaults { "" } else { "-minimal" };
        let name = format!("{program}{variant}-{target}");
        let program = target_dir().join(target).join(PROFILE).join(program);
        build_copy(build, scene, &program, &name)
    }
}

/// Runs a build command and copies the built program.
pub(crate) fn build_copy(
    mut build: Command,
    scene: Option<&Path>,
    program: &Path,
    name: &str,
) -> Result<PathBuf> {
    // Only one build runs at a time, because builds with different scenes or features write to the
    // same file.
    static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
    let _guard = ONE_AT_A_TIME.lock();

    if let Some(scene) = scene {
        build.env("SCENE", scene);
    }
    run(&mut build)?;
    let scene = scene.and_then(Path::file_stem).unwrap_or_default();
    let copy = scratch_dir()?.join(format!("{name}-{}.elf", scene.display()));
    fs::copy(program, &copy).with_context(|| format!("no firmware at {}", program.display()))?;
    Ok(copy)
}
