//! Compiles the scene that goes into flash: `SCENE`, relative to the root of the project.

fn main() -> Result<(), String> {
    println!("cargo::rerun-if-changed=memory.x");
    whitted_sim::flash::scene("../..", "scenes/whitted.toml")
}
