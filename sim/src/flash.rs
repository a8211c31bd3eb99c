//! Compiles scenes for firmware, in build scripts.
//!
//! Paths of scene files are relative to the folder that the caller names. The path of this folder
//! is relative to the package's folder. A file whose name does not end in `.toml` counts as a
//! compiled scene and is included unchanged.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

use crate::{input, scene_file};

/// Compiles a scene to `scene.bin` in Cargo's `OUT_DIR`, which firmware includes:
///
/// ```ignore
/// static SCENE: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/scene.bin"));
/// ```
///
/// The environment variable `SCENE` names the scene file. If this variable is not set, the file is
/// `default`.
///
/// If the scene has an error, or if a file cannot be read or written, the build fails, and Cargo
/// prints the message.
pub fn scene(folder: &str, default: &str) {
    let name = scene_variable().unwrap_or_else(|| default.into());
    let compiled = compiled(&Path::new(folder).join(name));
    report(compiled.and_then(|bytes| write("scene.bin", &bytes)));
}

/// Compiles scenes to a file that firmware includes:
///
/// ```ignore
/// include!(concat!(env!("OUT_DIR"), "/scenes.rs"));
/// ```
///
/// The file defines `static SCENES: [&[u8]; N]`, which has the compiled scenes. It also defines
/// `const COUNTS: SceneCounts`, which has the largest numbers of objects, lights and materials in
/// any of the scenes.
///
/// The environment variable `SCENE` lists the scene files, with the separator that `PATH` has. If
/// this variable is not set, the files are `defaults`.
///
/// If a scene has an error, or if a file cannot be read or written, the build fails, and Cargo prints
/// the message.
pub fn scenes(folder: &str, defaults: &[&str]) {
    report(write_scenes(folder, defaults));
}

fn write_scenes(folder: &str, defaults: &[&str]) -> Result<(), String> {
    let files: Vec<PathBuf> = match scene_variable() {
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

/// Tells Cargo that the build failed. Cargo prints each line of the message after the name of the
/// package.
fn report(outcome: Result<(), String>) {
    for line in outcome.err().iter().flat_map(|message| message.lines()) {
        println!("cargo::error={line}");
    }
}

/// Returns the environment variable `SCENE`.
fn scene_variable() -> Option<std::ffi::OsString> {
    println!("cargo::rerun-if-env-changed=SCENE");
    env::var_os("SCENE")
}

fn compiled(scene: &Path) -> Result<Vec<u8>, String> {
    println!("cargo::rerun-if-changed={}", scene.display());
    match scene.extension() {
        Some(extension) if extension == "toml" => {
            scene_file::compile(scene).map_err(|error| error.to_string())
        }
        _ => input::read(scene)
            .map_err(|error| format!("{}: cannot be read: {error}", scene.display())),
    }
}

/// Writes a file to `OUT_DIR`, the directory in which Cargo expects the output of a build script.
fn write(name: &str, bytes: &[u8]) -> Result<(), String> {
    let out = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set: call this from a build script")?;
    fs::write(PathBuf::from(out).join(name), bytes)
        .map_err(|error| format!("{name}: cannot be written: {error}"))
}
