//! Compiles `scene.toml` for the flash.
//!
//! The environment variable `SCENE` is the path of another scene file, relative to this folder.

fn main() {
    println!("cargo::rerun-if-changed=memory.x");
    println!("cargo::rustc-link-arg-bins=-Tdefmt.x");
    whitted_sim::flash::scene(".", "scene.toml");
}
