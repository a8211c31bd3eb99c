//! The project's tasks; `cargo xtask` lists them.
//!
//! A library, so that the tests in QEMU can build and run firmware with it.

pub mod bench;
pub mod board;
pub mod firmware;
pub mod model;
pub mod netduinoplus2;
pub mod oled;
pub mod pico;
pub mod povray;
pub mod profile;
pub mod prove;
pub mod qemu;
pub mod report;
pub mod size;
pub mod soak;
pub mod test;
pub mod tidy;

mod calls;
mod command;
mod qmp;
mod steps;
mod symbols;
mod tools;

use std::env;
use std::path::{Path, PathBuf};

/// The root of the project.
pub fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().unwrap_or(here)
}

/// The scene files of the project, by name.
pub fn scenes() -> anyhow::Result<Vec<PathBuf>> {
    let mut scenes = std::fs::read_dir(root().join("scenes"))?
        .map(|entry| Ok(entry?.path()))
        .collect::<anyhow::Result<Vec<_>>>()?;
    scenes.retain(|path| {
        path.extension()
            .is_some_and(|extension| extension == "toml")
    });
    scenes.sort();
    Ok(scenes)
}

/// Where Cargo builds.
pub fn target_dir() -> PathBuf {
    let named = env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into());
    root().join(named)
}

/// Where tasks keep their own files, made where missing.
pub fn scratch_dir() -> anyhow::Result<PathBuf> {
    let dir = target_dir().join("qemu");
    std::fs::create_dir_all(&dir)?;
    Ok(dir)
}
