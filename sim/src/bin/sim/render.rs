//! `sim render`, and `sim` alone.

use std::path::{Path, PathBuf};

use embedded_graphics::geometry::Size;
use whitted_sim::scene_file::Buffer;
use whitted_sim::{png16, render as library};

use crate::args::{Passes, Render, Shown};
use crate::display::Display;
use crate::draw::draw;
use crate::linear::linear;
use crate::open::Scene;
use crate::outcome::Outcome;
use crate::{report, terminal};

/// Renders the project's first scene and shows it.
pub(crate) fn default_scene() -> Outcome {
    let scene = Scene::open(Path::new("whitted"))?;
    let mut buffer = Box::new(Buffer::new());
    let prepared = scene.prepare(&mut buffer)?;
    let drawing = draw(
        &prepared,
        Size::new(320, 240),
        Shown::default(),
        Passes::default(),
    )?;
    terminal::show(&drawing.image)?;
    report::save(&drawing.image, Path::new("whitted.png"))?;
    Ok(())
}

/// Renders a scene to a PNG.
pub(crate) fn render(options: &Render) -> Outcome {
    let scene = Scene::open(&options.scene)?;
    let mut buffer = Box::new(Buffer::new());
    let prepared = scene.prepare_for(&options.quality, &mut buffer)?;
    let size = options.quality.size;
    let samples = options.passes.samples();
    let output = options
        .output
        .clone()
        .unwrap_or_else(|| named_after(&options.scene));
    let checksum = if options.linear16 {
        let linear = linear(&prepared, size, samples)?;
        png16::write(&output, &linear.picture)?;
        report::wrote(&output);
        if options.stats {
            report::stats(&linear.work, linear.time)?;
        }
        library::checksum(&linear.picture)
    } else {
        let display = options.display;
        let display = display.unwrap_or_else(|| Display::plain(size, options.shown.format));
        let mut shown = options.shown;
        shown.format = display.format;
        let drawing = draw(&prepared, display.size, shown, options.passes)?;
        report::save(&display.shown(&drawing.image, options.scale), &output)?;
        if !options.stats {
            return Ok(());
        }
        report::stats(&drawing.work, drawing.time)?;
        // The checksum is of linear samples, which a display does not keep.
        library::checksum(&linear(&prepared, display.size, samples)?.picture)
    };
    report::checksum(checksum);
    Ok(())
}

/// A PNG in the current directory.
fn named_after(scene: &Path) -> PathBuf {
    let stem = scene.file_stem().unwrap_or(scene.as_os_str());
    Path::new(stem).with_extension("png")
}
