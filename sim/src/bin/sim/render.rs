//! Implements `sim render`, and `sim` without a command.

use std::path::{Path, PathBuf};

use embedded_graphics::geometry::Size;
use whitted_sim::scene_file::Buffer;
use whitted_sim::{png16, render as library};

use crate::args::{DisplayOptions, Edges, Render};
use crate::console::Console;
use crate::draw::{Settings, draw};
use crate::linear::linear;
use crate::open::{Scene, find, stem};
use crate::outcome::Outcome;
use crate::output::{FileType, Output, io_error, write_png};
use crate::{report, terminal};

/// Renders scenes/whitted.toml to whitted.png and shows it in the terminal.
pub(crate) fn default_scene() -> Outcome {
    let scene = Scene::open(Path::new("whitted"))?;
    let mut buffer = Box::new(Buffer::new());
    let prepared = scene.prepare(&mut buffer)?;
    let path = Path::new("whitted.png");
    let output = Output::create(path, &FileType::PNG, &[])?;
    let size = Size::new(320, 240);
    let settings = Settings::new(size, DisplayOptions::default(), Edges::default());
    let drawing = draw(&prepared, &settings, 1)?;
    write_png(&drawing.image, output)?;
    terminal::show(&drawing.image)?;
    report::wrote(Console::Stdout, path)
}

/// Renders a scene to a PNG.
pub(crate) fn render(options: &Render) -> Outcome {
    let path = find(&options.scene)?;
    let scene = Scene::read(&path)?;
    let mut buffer = Box::new(Buffer::new());
    let prepared = scene.prepare_for(&options.quality, &mut buffer)?;
    check_scale(options)?;
    let file = options.output.clone();
    let file = file.unwrap_or_else(|| default_output(&path));
    let console = Console::beside(&file);
    let output = Output::create(&file, &FileType::PNG, &[path])?;
    let size = options.quality.size;
    let samples = options.passes.edges.samples();
    let checksum = if options.linear16 {
        let linear = linear(&prepared, size, samples)?;
        let picture = &linear.picture;
        output.write(|file| Ok(png16::encode(file, picture).map_err(io_error)?))?;
        report::wrote(console, &file)?;
        if options.stats {
            report::stats(console, &linear.work, linear.time)?;
        }
        library::checksum(picture)
    } else {
        let settings = Settings::new(size, options.display_options, options.passes);
        let drawing = draw(&prepared, &settings, options.scale)?;
        write_png(&drawing.image, output)?;
        report::wrote(console, &file)?;
        if !options.stats {
            return Ok(());
        }
        report::stats(console, &drawing.work, drawing.time)?;
        // The checksum is computed from 16-bit linear samples, but the picture has the display's
        // color format. The scene is therefore rendered a second time.
        library::checksum(&linear(&prepared, settings.display.size, samples)?.picture)
    };
    report::checksum(console, checksum)
}

/// Returns an error if the scaled picture would have more than 8192 pixels on a side. It would take
/// more than 0.5 GB of memory.
fn check_scale(options: &Render) -> Outcome {
    const MAX_SIDE: u32 = 8192;
    let display = options.display_options.display(options.quality.size);
    let size = display.size * options.scale;
    if size.width.max(size.height) > MAX_SIDE {
        return Err(format!(
            "--scale {}: the picture would have {}x{} pixels; the longest side is {MAX_SIDE}
  help: use a smaller --scale or --size",
            options.scale, size.width, size.height
        )
        .into());
    }
    Ok(())
}

/// Returns the default output path, which is a PNG in the current directory with the scene's name.
/// The name may contain dots.
fn default_output(scene: &Path) -> PathBuf {
    let mut name = stem(scene).to_owned();
    name.push(".png");
    name.into()
}
