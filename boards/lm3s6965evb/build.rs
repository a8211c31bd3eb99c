//! Compiles the scenes that go into flash.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, error::Error, fs};

use whitted_sim::scene_file;

/// The scenes that the select button goes through, unless told.
const SCENES: [&str; 5] = [
    "scenes/whitted.toml",
    "scenes/four_spheres.toml",
    "scenes/every_surface.toml",
    "scenes/sphereflake.toml",
    "scenes/tinted_diamond.toml",
];

/// Writes scenes.rs: the scenes above, or the one that the file named by
/// `SCENE` has, relative to the root of the project. A file that is not TOML is
/// taken for a compiled scene.
fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-env-changed=SCENE");
    println!("cargo::rerun-if-changed=../../memory.x");

    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let files: Vec<PathBuf> = match env::var_os("SCENE") {
        Some(scene) => vec![scene.into()],
        None => SCENES.map(PathBuf::from).into(),
    };
    let out = PathBuf::from(env::var("OUT_DIR")?);
    let mut counts = [0; 3];
    let mut scenes = String::new();
    for (index, file) in files.iter().enumerate() {
        let file = root.join(file);
        println!("cargo::rerun-if-changed={}", file.display());
        let compiled = compile(&file)?;
        let needed = whitted::counts(&compiled);
        counts = std::array::from_fn(|list| needed[list].max(counts[list]));
        let name = out.join(format!("{index}.bin"));
        fs::write(&name, compiled)?;
        writeln!(scenes, "    include_bytes!({name:?}),")?;
    }
    let text = format!(
        "const COUNTS: [usize; 3] = {counts:?};
static SCENES: [&[u8]; {}] = [\n{scenes}];\n",
        files.len(),
    );
    Ok(fs::write(out.join("scenes.rs"), text)?)
}

/// A scene for the decoder.
fn compile(file: &Path) -> Result<Vec<u8>, Box<dyn Error>> {
    if file
        .extension()
        .is_some_and(|extension| extension == "toml")
    {
        return Ok(scene_file::compile(file).map_err(|error| error.to_string())?);
    }
    Ok(fs::read(file).map_err(|error| format!("{}: {error}", file.display()))?)
}
