//! Compiles the scenes that go into flash: those that `SCENE` names, relative to the
//! root of the project, else those that the select button goes through.

fn main() -> Result<(), String> {
    println!("cargo::rerun-if-changed=../../memory.x");
    whitted_sim::flash::scenes(
        "../..",
        &[
            "scenes/whitted.toml",
            "scenes/four_spheres.toml",
            "scenes/every_surface.toml",
            "scenes/sphereflake.toml",
            "scenes/tinted_diamond.toml",
        ],
    )
}
