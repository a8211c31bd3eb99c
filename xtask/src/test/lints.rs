//! Runs Clippy.

use anyhow::Result;

use crate::command::{cargo, run};
use crate::firmware::{V6M, V7M};

/// Cargo arguments of all steps on the host. The steps use the same arguments, so that they share
/// one build.
pub(super) const WINDOW: [&str; 2] = ["--features", "whitted-sim/window"];

/// Firmware packages in the root workspace.
const FIRMWARE: [&str; 8] = [
    "choices",
    "float",
    "headless",
    "lm3s6965evb",
    "motion",
    "nopanic",
    "products",
    "soak",
];

/// Lints for the library only. They forbid panics and arithmetic with results that may differ
/// between targets. The lints are not in Cargo.toml, because they would also apply to tests. Tests
/// may panic and compute with floats.
const LIBRARY: [&str; 8] = [
    "clippy::expect_used",
    "clippy::float_arithmetic",
    "clippy::float_cmp",
    "clippy::panic",
    "clippy::todo",
    "clippy::unimplemented",
    "clippy::unreachable",
    "clippy::unwrap_used",
];

/// Lints all packages that run on the host, and the simulator without the feature `window`.
pub(super) fn host() -> Result<()> {
    clippy(&["--all-targets", WINDOW[0], WINDOW[1]], &[])?;
    clippy(&["--bin", "sim"], &[])
}

/// Lints the library for the smallest target. Also lints the firmware packages.
pub(super) fn thumb() -> Result<()> {
    library(&["--target", V6M])?;
    let mut arguments = vec!["--target", V7M];
    arguments.extend(FIRMWARE.iter().flat_map(|package| ["--package", package]));
    clippy(&arguments, &[])
}

/// Lints the library, without its tests.
pub(super) fn library(arguments: &[&str]) -> Result<()> {
    let arguments = [&["--package", "whitted", "--lib"], arguments].concat();
    clippy(&arguments, &LIBRARY)
}

fn clippy(arguments: &[&str], denied: &[&str]) -> Result<()> {
    let mut clippy = cargo();
    clippy.args(["clippy", "--quiet"]).args(arguments);
    clippy.args(["--", "-D", "warnings"]);
    clippy.args(denied.iter().flat_map(|lint| ["-D", lint]));
    run(&mut clippy)
}
