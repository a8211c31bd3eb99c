//! Implements `sim check` and `sim compile`.

use std::fs;
use std::path::Path;

use whitted::scene::SceneCounts;
use whitted_sim::scene_file::Buffer;

use crate::memory::memory;
use crate::open::Scene;
use crate::outcome::Outcome;

/// Checks a scene and its animation. Prints counts and memory use, and warnings about parts of the
/// scene that have no effect.
pub(crate) fn check(path: &Path) -> Outcome {
    let scene = Scene::open(path)?;
    let mut buffer = Box::new(Buffer::new());
    scene.check_frames()?;
    let prepared = scene.prepare(&mut buffer)?;
    let counts = prepared.counts();
    let SceneCounts {
        objects,
        lights,
        materials,
        ..
    } = counts;
    let counted = [
        count(objects, "object"),
        count(lights, "light"),
        count(materials, "material"),
    ];
    println!("{}: ok, {}", path.display(), counted.join(", "));
    let bytes = memory(counts);
    println!("prepared: {bytes} bytes, SceneBuffer<{objects}, {lights}, {materials}>");
    println!("compiled: {} bytes", prepared.encoded_len());
    for warning in scene.warnings(&prepared) {
        eprintln!("warning: {warning}");
    }
    Ok(())
}

fn count(count: usize, name: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {name}{plural}")
}

/// Compiles a scene to a file.
pub(crate) fn compile(path: &Path, output: &Path) -> Outcome {
    let bytes = Scene::open(path)?.compile()?;
    let length = bytes.len();
    let name = output.display();
    fs::write(output, &bytes).map_err(|error| format!("{name}: cannot be written: {error}"))?;
    println!("wrote {name}: {length} bytes");
    Ok(())
}
