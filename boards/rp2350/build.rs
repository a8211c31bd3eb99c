//! Compiles the scene for the flash.
//!
//! The environment variable `SCENE` is the path of the scene file, relative to the project
//! root.

fn main() {
    println!("cargo::rerun-if-changed=memory.x");
    whitted_sim::flash::scene("../..", "scenes/whitted.toml");
}
