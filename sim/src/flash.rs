//! A scene into flash: what build scripts of firmware do.

use std::path::{Path, PathBuf};
use std::{env, fs};

use crate::scene_file;

/// Compiles a scene to `scene.bin` in Cargo's `OUT_DIR`, from where firmware
/// includes it:
///
/// ```ignore
/// static SCENE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/scene.bin"));
/// ```
///
/// The scene is the file that the environment variable `SCENE` names, else
/// `default`, both relative to `folder`; and that to the package. A file that is
/// not TOML is taken for a compiled scene.
///
/// # Errors
/// What is wrong with the scene, and in which line; or a file that cannot be
/// read or written.
pub fn scene(folder: &str, default: &str) -> Result<(), String> {
    println!("cargo::rerun-if-env-changed=SCENE");
    let name = env::var_os("SCENE").unwrap_or_else(|| default.into());
    let scene = Path::new(folder).join(name);
    println!("cargo::rerun-if-changed={}", scene.display());

    let unusable = |error| format!("{}: {error}", scene.display());
    let compiled = match scene.extension() {
        Some(extension) if extension == "toml" => {
            scene_file::compile(&scene).map_err(|error| error.to_string())?
        }
        _ => fs::read(&scene).map_err(unusable)?,
    };
    let out = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: this is for build scripts")?;
    fs::write(PathBuf::from(out).join("scene.bin"), compiled).map_err(|error| error.to_string())
}
