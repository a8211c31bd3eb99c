//! Compiles the scenes that go into flash: those that `SCENE` names, relative to the
//! root of the project and separated as in `PATH`, else a few of the project's.

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
