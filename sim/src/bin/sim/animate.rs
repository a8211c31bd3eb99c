//! `sim animate`: renders an animated scene frame by frame.
//!
//! ```text
//! schedule (times) ── scene file (keyframes) ── draw ──> GIF, APNG, or numbered PNGs
//! ```

mod apng;
mod difference;
mod film;
mod gif;
mod numbered;
mod palette;
mod schedule;

use std::path::Path;

use embedded_graphics::geometry::Size;
use whitted_sim::scene_file::{AnimatedScene, Buffer, FileAnimation, SceneFile};

use crate::args::{Animate, Passes};
use crate::draw::draw_frame;
use crate::open::{Scene, apply_overrides};
use crate::outcome::Outcome;
use crate::progress::Progress;
use crate::report;
use film::Film;
use schedule::Schedule;

/// Renders all frames of a scene's animation.
pub(crate) fn animate(options: &Animate) -> Outcome {
    let Animate {
        quality, output, ..
    } = options;
    let mut file = scene_file(&options.scene)?;
    let has_animation = file.animation.is_some();
    let animation = file
        .animation
        .get_or_insert_with(FileAnimation::single_orbit);
    let schedule = Schedule::new(animation, options.fps, options.frames)?;
    let mut film = film(output, quality.size, &schedule)?;
    let mut progress = Progress::new(schedule.times.len() as u64 * u64::from(quality.size.height));
    let mut animated = Box::new(AnimatedScene::new());
    let mut buffer = Box::new(Buffer::new());
    for time in &schedule.times {
        let scene = file.frame(&mut animated, *time)?;
        let mut prepared = buffer
            .prepare(&scene)
            .map_err(|error| file.explain_frame(error, *time))?;
        apply_overrides(&mut prepared, quality)?;
        let (image, _) = draw_frame(
            &prepared,
            quality.size,
            options.display_options,
            Passes::default(),
            &mut progress,
        )?;
        film.add(image.as_image_buffer().as_raw())?;
    }
    progress.finish();
    film.finish()?;
    if !has_animation {
        println!("the scene has no [animation]: the camera makes one orbit");
    }
    report::wrote(output);
    Ok(())
}

fn scene_file(path: &Path) -> Outcome<SceneFile> {
    match Scene::open(path)? {
        Scene::File(file) => Ok(*file),
        Scene::Compiled { name, .. } => Err(format!(
            "{name}: a compiled scene has no animation\n  help: animate the scene file that it was compiled from"
        )
        .into()),
    }
}

/// Creates the writer of the animation. The file extension of `output` selects the file format.
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
            "{}: unknown animation format\n  help: write FILE.gif, FILE.apng, or DIR/ for numbered PNGs",
            output.display()
        )
        .into()),
    }
}
