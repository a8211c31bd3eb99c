//! `sim animate`: renders an animated scene frame by frame.
//!
//! ```text
//! schedule (times) ── frames (compiled scene, draw) ──> GIF, APNG, or numbered PNGs
//! ```

mod apng;
mod container;
mod difference;
mod frames;
mod gif;
mod numbered;
mod palette;
mod samples;
mod schedule;

use std::io::Write;
use std::path::{Path, PathBuf};

use whitted_sim::scene_file::{Buffer, FileAnimation};

use crate::args::{Animate, Container};
use crate::console::Console;
use crate::draw::Settings;
use crate::open::{Scene, find};
use crate::outcome::Outcome;
use crate::output::{FileType, Output};
use crate::report;
use container::container;
use frames::Frames;
use schedule::Schedule;

/// Renders all frames of a scene's animation.
pub(crate) fn animate(options: &Animate) -> Outcome {
    let path = find(&options.scene)?;
    let mut scene = Scene::read(&path)?;
    let has_animation = add_orbit(&mut scene);
    let compiled = scene.compile()?;
    let mut buffer = Box::new(Buffer::new());
    let animation = buffer.decode_animation(&compiled)?;
    if !animation.is_animated() {
        return Err(without_animation(&path).into());
    }
    let (duration, looping) = (animation.duration(), animation.is_looping());
    let schedule = Schedule::new(duration, looping, options.fps, options.frames)?;
    let container = container(&options.output, options.container)?;
    let settings = Settings::new(options.quality.size, options.display_options, options.edges);
    let frames = || Frames::new(&scene, animation, options.quality, settings, &schedule);
    let mut console = Console::beside(&options.output);
    write(&options.output, &[path], container, &schedule, frames)?;
    if !has_animation {
        writeln!(
            console,
            "the scene has no [animation]: the camera makes one orbit"
        )?;
    }
    report::wrote(console, &options.output)
}

/// Checks the output, and then renders the frames and writes them.
fn write<'a>(
    output: &Path,
    inputs: &[PathBuf],
    container: Option<Container>,
    schedule: &Schedule,
    frames: impl FnOnce() -> Outcome<Frames<'a>>,
) -> Outcome {
    let in_file = |error| format!("{}: {error}", output.display());
    match container {
        None => numbered::write(output, inputs, &mut frames()?),
        Some(Container::Gif) => {
            let delays = gif::delays(schedule).map_err(in_file)?;
            let output = Output::create(output, &FileType::GIF, inputs)?;
            let mut frames = frames()?;
            output.write(|file| gif::write(&mut frames, &delays, file))
        }
        Some(Container::Apng) => {
            let delays = apng::delays(schedule).map_err(in_file)?;
            let output = Output::create(output, &FileType::APNG, inputs)?;
            let mut frames = frames()?;
            output.write(|file| apng::write(&mut frames, &delays, file))
        }
    }
}

/// If a scene file has no animation, adds an orbit of the camera. Returns false in this case.
fn add_orbit(scene: &mut Scene) -> bool {
    let Scene::File(file) = scene else {
        return true;
    };
    let has_animation = file.animation.is_some();
    file.animation
        .get_or_insert_with(FileAnimation::single_orbit);
    has_animation
}

fn without_animation(path: &Path) -> String {
    format!(
        "{}: this compiled scene has no animation\n  help: animate the scene file that it was compiled from",
        path.display()
    )
}
