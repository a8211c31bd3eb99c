//! The tasks of the project. `cargo xtask help` lists them.
//!
//! The tasks are in a library, so that the tests in `xtask/tests` can use them to build firmware
//! and to run it in emulators.

pub mod bench;
pub mod board;
pub mod core;
pub mod firmware;
pub mod fit;
pub mod host;
pub mod netduinoplus2;
pub mod oled;
pub mod pico;
pub mod profile;
pub mod prove;
pub mod qemu;
pub mod report;
pub mod size;
pub mod soak;
pub mod test;
pub mod tidy;

mod budget;
mod command;
mod panics;
mod parallel;
mod qmp;
mod steps;
mod symbols;
mod tools;

use std::path::{Path, PathBuf};
use std::{env, fs};

use anyhow::Result;

/// Returns the root folder of the project.
pub fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here)
}

/// Returns the path of the scene with this name in `tests/scenes`. Measurements use the scenes in
/// this folder, because these scenes never change.
pub fn scene(name: &str) -> PathBuf {
    root()
        .join("tests/scenes")
        .join(name)
        .with_extension("toml")
}

/// Returns the path of the scene with this name in `scenes`. The boards draw scenes of this folder
/// unless they are built with other scenes.
pub fn gallery_scene(name: &str) -> PathBuf {
    root().join("scenes").join(name).with_extension("toml")
}

/// Returns the paths of the scene files in `tests/scenes`, sorted by name.
pub fn scenes() -> Result<Vec<PathBuf>> {
    let mut scenes = fs::read_dir(root().join("tests/scenes"))?
        .map(|entry| Ok(entry?.path()))
        .collect::<Result<Vec<_>>>()?;
    scenes.retain(|path| {
        path.extension()
            .is_some_and(|extension| extension == "toml")
    });
    scenes.sort();
    Ok(scenes)
}

/// Returns Cargo's target folder.
pub fn target_dir() -> PathBuf {
    let named = env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
    root().join(named)
}

/// Returns the folder for compiled scenes, firmware and screenshots. Creates the folder if it does
/// not exist.
pub fn scratch_dir() -> Result<PathBuf> {
    let dir = target_dir().join("qemu");
    fs::create_dir_all(&dir)?;
    Ok(dir)
}
