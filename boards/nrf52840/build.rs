//! Compiles the scene for the flash.
//!
//! The environment variable `SCENE` selects a scene file, relative to the project root.

fn main() -> Result<(), String> {
    println!("cargo::rerun-if-changed=memory.x");
    whitted_sim::flash::scene("../..", "scenes/whitted.toml")
}
