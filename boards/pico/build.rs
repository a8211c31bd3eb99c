//! Compiles the scenes that go into flash.

use std::path::{Path, PathBuf};
use std::{env, error::Error, fs};

use whitted::{Camera, Real, Vec3};
use whitted_sim::scene_file;

const DEFAULT: [&str; 3] = ["whitted", "four_spheres", "every_surface"];

/// The scene files named by `SCENE`, relative to the root of the project and
/// separated as in `PATH`, else a few of the project's.
fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-env-changed=SCENE");
    println!("cargo::rerun-if-changed=memory.x");

    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let named = match env::var_os("SCENE") {
        Some(list) => env::split_paths(&list).collect(),
        None => DEFAULT
            .map(|name| PathBuf::from(format!("scenes/{name}.toml")))
            .to_vec(),
    };
    let out = PathBuf::from(env::var("OUT_DIR")?);
    let mut list = String::new();
    for (number, name) in named.iter().enumerate() {
        let scene = root.join(name);
        println!("cargo::rerun-if-changed={}", scene.display());
        let camera = scene_file::load(&scene)
            .map_err(|error| error.to_string())?
            .scene()
            .camera;
        let compiled = scene_file::compile(&scene).map_err(|error| error.to_string())?;
        fs::write(out.join(format!("{number}.bin")), compiled)?;
        list += &format!(
            "FlashScene {{ compiled: include_bytes!(\"{number}.bin\"), camera: {} }},\n",
            in_rust(camera)
        );
    }
    Ok(fs::write(out.join("scenes.rs"), format!("&[\n{list}]"))?)
}

/// A camera, exactly, as Rust has it in constants.
fn in_rust(camera: Camera) -> String {
    let number = |value: Real| format!("Real::from_bits({})", value.to_bits());
    let vector = |Vec3 { x, y, z }: Vec3<Real>| {
        format!("Vec3::new({}, {}, {})", number(x), number(y), number(z))
    };
    format!(
        "Camera {{ eye: {}, look_at: {}, up: {}, fovy_deg: {} }}",
        vector(camera.eye),
        vector(camera.look_at),
        vector(camera.up),
        number(camera.fovy_deg)
    )
}
