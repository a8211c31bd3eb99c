//! Building firmware.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use anyhow::{Context, Result};

use crate::command::{cargo, run};
use crate::{scratch_dir, target_dir};

/// A package of `boards`, built for a target.
#[derive(Clone, Copy, Debug)]
pub struct Firmware {
    /// The package, and the program in it.
    pub package: &'static str,
    /// The target.
    pub target: &'static str,
    /// Features of the package, or nothing.
    pub features: &'static str,
}

/// Instructions of the Cortex-M0 and M0+.
pub const V6M: &str = "thumbv6m-none-eabi";
/// Instructions of the Cortex-M3.
pub const V7M: &str = "thumbv7m-none-eabi";
/// Instructions of the Cortex-M4F and M7, with floats in hardware.
pub const V7EM: &str = "thumbv7em-none-eabihf";

/// Instructions of the Cortex-M33, with floats in hardware.
pub const V8M: &str = "thumbv8m.main-none-eabihf";

/// Every target that there is firmware for.
pub const TARGETS: [&str; 4] = [V6M, V7M, V7EM, V8M];

/// What the root manifest calls the profile for microcontrollers.
pub(crate) const PROFILE: &str = "firmware";

/// The board with the OLED.
pub const LM3S6965EVB: Firmware = Firmware {
    package: "lm3s6965evb",
    target: V7M,
    features: "",
};

/// The firmware that draws any scene, for each kind of core.
pub const HEADLESS: [Firmware; 4] = [headless(V6M), headless(V7M), headless(V7EM), headless(V8M)];

/// The firmware with room for 256 objects, on the Cortex-M3.
pub(crate) const CROWD: Firmware = Firmware {
    features: "crowd",
    ..headless(V7M)
};

/// Compares products with the plain ones, for each kind of core, as they are in assembly.
pub(crate) const fn products(target: &'static str) -> Firmware {
    Firmware {
        package: "products",
        target,
        features: "",
    }
}

/// Draws frames of a scene that moves, for each kind of core.
pub const MOTION: [Firmware; 4] = [motion(V6M), motion(V7M), motion(V7EM), motion(V8M)];

/// Draws frames without end, for each kind of core.
pub(crate) const fn soak(target: &'static str) -> Firmware {
    Firmware {
        package: "soak",
        target,
        features: "",
    }
}

/// The yardstick in floating point, for each kind of core.
pub const FLOAT: [Firmware; 4] = [float(V6M), float(V7M), float(V7EM), float(V8M)];

pub(crate) const fn headless(target: &'static str) -> Firmware {
    Firmware {
        package: "headless",
        target,
        features: "",
    }
}

const fn motion(target: &'static str) -> Firmware {
    Firmware {
        package: "motion",
        target,
        features: "",
    }
}

pub(crate) const fn float(target: &'static str) -> Firmware {
    Firmware {
        package: "float",
        target,
        features: "",
    }
}

/// Links only if nothing of the library may panic.
pub(crate) const fn nopanic(target: &'static str) -> Firmware {
    Firmware {
        package: "nopanic",
        target,
        features: "",
    }
}

impl Firmware {
    /// Builds it, for firmware with a scene in flash with this one in place of
    /// the default scene, and returns the program, as a file that a later build
    /// does not change.
    pub fn build(self, scene: Option<&Path>) -> Result<PathBuf> {
        // Builds with other scenes give a file of the same name.
        static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
        let _guard = ONE_AT_A_TIME.lock();

        let mut build = cargo();
        build.args(["build", "--quiet", "--profile", PROFILE]);
        build.args(["--package", self.package, "--target", self.target]);
        build.args(["--features", self.features]);
        if let Some(scene) = scene {
            build.env("SCENE", scene);
        }
        run(&mut build)?;

        let program = target_dir()
            .join(self.target)
            .join(PROFILE)
            .join(self.package);
        let scene = scene.and_then(Path::file_stem).unwrap_or_default();
        let Self {
            package,
            target,
            features,
        } = self;
        let name = format!("{package}{features}-{target}-{}.elf", scene.display());
        let copy = scratch_dir()?.join(name);
        fs::copy(&program, &copy)
            .with_context(|| format!("no firmware at {}", program.display()))?;
        Ok(copy)
    }
}
