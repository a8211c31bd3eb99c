//! Compiles the scenes for the flash.
//!
//! The environment variable `SCENE` selects scene files, relative to the project root and
//! separated as in `PATH`. The default scenes are listed below.

fn main() -> Result<(), String> {
    println!("cargo::rerun-if-changed=memory.x");
    whitted_sim::flash::scenes(
        "../..",
        &[
            "scenes/whitted.toml",
            "scenes/four_spheres.toml",
            "scenes/every_surface.toml",
        ],
    )
}
