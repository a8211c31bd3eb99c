//! `sim animate`: a scene at one time after the other.
//!
//! schedule (when) ── scene file (where) ── draw ──> GIF, APNG, or numbered PNGs

mod apng;
mod change;
mod gif;
mod numbered;
mod palette;
mod schedule;

use std::path::Path;

use embedded_graphics::geometry::Size;
use whitted::Real;
use whitted_sim::scene_file::{Buffer, Motion, SceneFile, Stage};

use crate::args::{Animate, Passes};
use crate::draw::frame;
use crate::open::{Scene, overrule};
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::report;
use schedule::Schedule;

/// What frames are written to, in order.
trait Film {
    /// Takes the next frame: red, green and blue of each pixel.
    fn add(&mut self, pixels: &[u8]) -> Outcome;

    /// Writes what is left to be written.
    fn finish(self: Box<Self>) -> Outcome;
}

/// Renders a scene that moves.
pub(crate) fn animate(options: &Animate) -> Outcome {
    let Animate {
        quality, output, ..
    } = options;
    let mut file = scene_file(&options.scene)?;
    let is_still = file.animation.is_none();
    let motion = file.animation.get_or_insert_with(Motion::once_around);
    let schedule = Schedule::new(motion, options.fps, options.frames)?;
    let mut film = film(output, quality.size, &schedule)?;
    let mut progress = Progress::new(schedule.times.len() as u64 * u64::from(quality.size.height));
    let mut stage = Box::new(Stage::new());
    let mut buffer = Box::new(Buffer::new());
    for time in &schedule.times {
        let scene = file.frame(&mut stage, *time)?;
        let mut prepared = buffer
            .prepare(&scene)
            .map_err(|error| file.explain_frame(error, *time))?;
        overrule(&mut prepared, quality)?;
        let (image, _) = frame(
            &prepared,
            quality.size,
            options.shown,
            Passes::default(),
            &mut progress,
        )?;
        film.add(image.as_image_buffer().as_raw())?;
    }
    progress.finish();
    film.finish()?;
    if is_still {
        println!("the scene has no [animation]: its camera orbits once");
    }
    report::wrote(output);
    Ok(())
}

fn scene_file(path: &Path) -> Outcome<SceneFile> {
    match Scene::open(path)? {
        Scene::File(file) => Ok(*file),
        Scene::Compiled { name, .. } => Err(format!(
            "{name}: a compiled scene does not move\n  help: animate the scene file that it was compiled from"
        )
        .into()),
    }
}

/// What the output's name asks for.
fn film(output: &Path, size: Size, schedule: &Schedule) -> Outcome<Box<dyn Film>> {
    let extension = output.extension().map(|it| it.to_ascii_lowercase());
    let extension = extension.as_deref().and_then(|it| it.to_str());
    let is_directory = output.is_dir() || output.as_os_str().to_string_lossy().ends_with('/');
    match extension {
        _ if is_directory => numbered::film(output, size, schedule),
        None => numbered::film(output, size, schedule),
        Some("gif") => gif::film(output, size, schedule),
        Some("apng" | "png") => apng::film(output, size, schedule),
        Some(_) => Err(format!(
            "{}: no known kind of animation\n  help: write FILE.gif, FILE.apng, or DIR/ for numbered PNGs",
            output.display()
        )
        .into()),
    }
}

/// What to say of a file that cannot be written.
fn unwritable(path: &Path, error: impl std::fmt::Display) -> String {
    format!("{}: cannot be written: {error}", path.display())
}

/// Seconds as a multiple of a fraction of them, rounded.
fn in_units(seconds: Real, per_second: u32) -> u64 {
    let twice = (i128::from(seconds.to_bits()) * i128::from(per_second)) >> 31;
    ((twice + 1) >> 1) as u64
}
