//! Scenes into flash: what build scripts of firmware do.
//!
//! A scene is a file, relative to the folder that is given, and that to the
//! package. A file that is not TOML is taken for a compiled scene.

use std::fmt::Write;
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
/// It is the scene that the environment variable `SCENE` names, else `default`.
///
/// # Errors
/// What is wrong with the scene, and in which line; or a file that cannot be
/// read or written.
pub fn scene(folder: &str, default: &str) -> Result<(), String> {
    let name = named().unwrap_or_else(|| default.into());
    write("scene.bin", &compiled(&Path::new(folder).join(name))?)
}

/// Compiles scenes to a file that firmware includes:
///
/// ```ignore
/// include!(concat!(env!("OUT_DIR"), "/scenes.rs"));
/// ```
///
/// It has `static SCENES: [&[u8]; N]`, and `const COUNTS: [usize; 3]`, the most objects,
/// lights and materials that one of them has.
///
/// They are those that the environment variable `SCENE` names, separated as in
/// `PATH`, else the defaults.
///
/// # Errors
/// As [`scene`].
pub fn scenes(folder: &str, defaults: &[&str]) -> Result<(), String> {
    let files: Vec<PathBuf> = match named() {
        Some(list) => env::split_paths(&list).collect(),
        None => defaults.iter().map(PathBuf::from).collect(),
    };
    let mut list = String::new();
    for (number, file) in files.iter().enumerate() {
        let compiled = compiled(&Path::new(folder).join(file))?;
        write(&format!("{number}.bin"), &compiled)?;
        _ = writeln!(list, "    include_bytes!(\"{number}.bin\"),");
    }
    let length = files.len();
    let text = format!(
        "static SCENES: [&[u8]; {length}] = [\n{list}];
const COUNTS: whitted::scene::SceneCounts = whitted::scene::SceneCounts::of_all(&SCENES);\n"
    );
    write("scenes.rs", text.as_bytes())
}

/// What `SCENE` says.
fn named() -> Option<std::ffi::OsString> {
    println!("cargo::rerun-if-env-changed=SCENE");
    env::var_os("SCENE")
}

fn compiled(scene: &Path) -> Result<Vec<u8>, String> {
    println!("cargo::rerun-if-changed={}", scene.display());
    match scene.extension() {
        Some(extension) if extension == "toml" => {
            scene_file::compile(scene).map_err(|error| error.to_string())
        }
        _ => fs::read(scene).map_err(|error| format!("{}: {error}", scene.display())),
    }
}

/// Into Cargo's directory for what build scripts write.
fn write(name: &str, bytes: &[u8]) -> Result<(), String> {
    let out = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: this is for build scripts")?;
    fs::write(PathBuf::from(out).join(name), bytes).map_err(|error| format!("{name}: {error}"))
}
