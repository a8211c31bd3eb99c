//! Builds firmware that is a package of the workspace.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

use anyhow::{Context, Result};

use crate::command::{cargo, run};
use crate::{scratch_dir, target_dir};

/// Target of the Cortex-M0 and M0+.
pub const V6M: &str = "thumbv6m-none-eabi";
/// Target of the Cortex-M3.
pub const V7M: &str = "thumbv7m-none-eabi";
/// Target of the Cortex-M4F and M7, with an FPU.
pub const V7EM: &str = "thumbv7em-none-eabihf";
/// Target of the Cortex-M33, with an FPU.
pub const V8M: &str = "thumbv8m.main-none-eabihf";

/// Targets of all firmware for Cortex-M.
pub const TARGETS: [&str; 4] = [V6M, V7M, V7EM, V8M];

/// Cargo profile for microcontrollers in the root manifest.
pub(crate) const PROFILE: &str = "firmware";

/// A package of the workspace, built for a target.
#[derive(Clone, Copy, Debug)]
pub struct Firmware {
    /// Name of the package and its program.
    pub package: &'static str,
    /// Target triple.
    pub target: &'static str,
    /// True to build with the package's default features.
    pub defaults: bool,
}

/// The LM3S6965 board with an OLED display.
pub const LM3S6965EVB: Firmware = Firmware::new("lm3s6965evb", V7M);

impl Firmware {
    /// Returns a package with its default features.
    pub const fn new(package: &'static str, target: &'static str) -> Self {
        Self {
            package,
            target,
            defaults: true,
        }
    }

    /// Builds the firmware and returns the path of a copy that later builds do not overwrite.
    /// `scene` replaces the default scene of firmware with a scene in flash.
    pub fn build(self, scene: Option<&Path>) -> Result<PathBuf> {
        let Self {
            package,
            target,
            defaults,
        } = self;
        let mut build = cargo();
        build.args(["build", "--quiet", "--profile", PROFILE]);
        build.args(["--package", package, "--target", target]);
        if !defaults {
            build.arg("--no-default-features");
        }
        let program = target_dir().join(target).join(PROFILE).join(package);
        let variant = if defaults { "" } else { "-minimal" };
        let name = format!("{package}{variant}-{target}");
        build_copy(build, scene, &program, &name)
    }
}

/// Runs a build and copies the program.
pub(crate) fn build_copy(
    mut build: Command,
    scene: Option<&Path>,
    program: &Path,
    name: &str,
) -> Result<PathBuf> {
    // Builds with other scenes or features have the same file name.
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
