//! Clippy.

use anyhow::Result;

use crate::command::{cargo, run};
use crate::firmware::{V6M, V7M};

/// Feature of everything on the host, so that all steps share one build.
pub(super) const WINDOW: [&str; 2] = ["--features", "whitted-sim/window"];

/// Packages of firmware in the workspace.
const FIRMWARE: [&str; 7] = [
    "float",
    "headless",
    "lm3s6965evb",
    "motion",
    "nopanic",
    "products",
    "soak",
];

/// Lints for the library alone: no panics, and the same arithmetic on every target. Tests may
/// panic and compute with floats, so Cargo.toml cannot have these lints.
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

/// Lints everything on the host, and the simulator without a window.
pub(super) fn host() -> Result<()> {
    clippy(&["--all-targets", WINDOW[0], WINDOW[1]], &[])?;
    clippy(&["--bin", "sim"], &[])
}

/// Lints the library on the smallest target, and all firmware.
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
