//! Compiles the scene that goes into flash: `SCENE`, relative to the root of the project.

fn main() -> Result<(), String> {
    whitted_sim::flash::scene("../..", "scenes/whitted.toml")
}
