//! Implements `sim check` and `sim compile`.

use std::io::Write;
use std::path::Path;

use whitted::scene::SceneCounts;
use whitted_sim::scene_file::Buffer;

use crate::console::Console;
use crate::memory::memory;
use crate::open::{Scene, find};
use crate::outcome::Outcome;
use crate::output::{FileType, Output};

/// Checks a scene and its animation. Prints counts and memory use, and warnings about parts of the
/// scene that have no effect.
pub(crate) fn check(path: &Path) -> Outcome {
    let scene = Scene::open(path)?;
    let mut buffer = Box::new(Buffer::new());
    let compiled = scene.compile()?;
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
    let mut console = Console::Stdout;
    writeln!(console, "{}: ok, {}", path.display(), counted.join(", "))?;
    let bytes = memory(counts);
    writeln!(
        console,
        "prepared: {bytes} bytes, SceneBuffer<{objects}, {lights}, {materials}>"
    )?;
    writeln!(console, "compiled: {} bytes", compiled.len())?;
    for warning in scene.warnings(&prepared) {
        writeln!(Console::Stderr, "warning: {warning}")?;
    }
    Ok(())
}

fn count(count: usize, name: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {name}{plural}")
}

/// Compiles a scene to a file.
pub(crate) fn compile(path: &Path, output: &Path) -> Outcome {
    let scene = find(path)?;
    let bytes = Scene::read(&scene)?.compile()?;
    let mut console = Console::beside(output);
    let file = Output::create(output, &FileType::COMPILED_SCENE, &[scene])?;
    file.write(|file| Ok(file.write_all(&bytes)?))?;
    if console == Console::Stdout {
        writeln!(console, "wrote {}: {} bytes", output.display(), bytes.len())?;
    }
    Ok(())
}
