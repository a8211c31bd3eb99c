//! Compiles the scene that goes into flash.

use std::path::{Path, PathBuf};
use std::{env, error::Error, fs};

/// The scene file named by `SCENE`, relative to the root of the project, else
/// the default scene. A file that is not TOML is taken for a compiled scene.
fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-env-changed=SCENE");
    println!("cargo::rerun-if-changed=../../memory.x");

    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let scene = root.join(env::var_os("SCENE").unwrap_or_else(|| "scenes/whitted.toml".into()));
    println!("cargo::rerun-if-changed={}", scene.display());

    let is_toml = scene
        .extension()
        .is_some_and(|extension| extension == "toml");
    let compiled = if is_toml {
        whitted_sim::scene_file::compile(&scene).map_err(|error| error.to_string())?
    } else {
        fs::read(&scene).map_err(|error| format!("{}: {error}", scene.display()))?
    };
    let out = PathBuf::from(env::var("OUT_DIR")?).join("scene.bin");
    Ok(fs::write(out, compiled)?)
}
