//! Implements `sim render`, and `sim` without a command.

use std::path::{Path, PathBuf};

use embedded_graphics::geometry::Size;
use whitted_sim::scene_file::Buffer;
use whitted_sim::{png16, render as library};

use crate::args::{DisplayOptions, Passes, Render};
use crate::display::Display;
use crate::draw::draw;
use crate::linear::linear;
use crate::open::Scene;
use crate::outcome::Outcome;
use crate::{report, terminal};

/// Renders scenes/whitted.toml to whitted.png and shows it in the terminal.
pub(crate) fn default_scene() -> Outcome {
    let scene = Scene::open(Path::new("whitted"))?;
    let mut buffer = Box::new(Buffer::new());
    let prepared = scene.prepare(&mut buffer)?;
    let drawing = draw(
        &prepared,
        Size::new(320, 240),
        DisplayOptions::default(),
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
        .unwrap_or_else(|| default_output(&options.scene));
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
        let display =
            display.unwrap_or_else(|| Display::plain(size, options.display_options.format));
        let display_options = options.display_options.with_format(display.format);
        let drawing = draw(&prepared, display.size, display_options, options.passes)?;
        report::save(&display.appearance(&drawing.image, options.scale), &output)?;
        if !options.stats {
            return Ok(());
        }
        report::stats(&drawing.work, drawing.time)?;
        // The checksum is computed from 16-bit linear samples, but the picture has the display's
        // color format. The scene is therefore rendered a second time.
        library::checksum(&linear(&prepared, display.size, samples)?.picture)
    };
    report::checksum(checksum);
    Ok(())
}

/// Returns the default output path, which is a PNG in the current directory with the scene's name.
fn default_output(scene: &Path) -> PathBuf {
    let stem = scene.file_stem().unwrap_or(scene.as_os_str());
    Path::new(stem).with_extension("png")
}
