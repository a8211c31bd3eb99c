//! Compiles the scenes for the flash.
//!
//! The environment variable `SCENE` lists the paths of scene files, relative to the project
//! root. The paths are separated like folders in `PATH`. Without `SCENE`, the build script
//! compiles the scenes listed below.

fn main() {
    println!("cargo::rerun-if-changed=memory.x");
    whitted_sim::flash::scenes(
        "../..",
        &[
            "scenes/whitted.toml",
            "scenes/four_spheres.toml",
            "scenes/every_surface.toml",
        ],
    );
}
