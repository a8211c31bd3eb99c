//! `sim gallery`: renders scenes to PNGs, and writes an HTML page and a contact sheet that show
//! them.

mod page;
mod sheet;
mod thumbnail;

use std::fs;
use std::path::{Path, PathBuf};

use embedded_graphics::geometry::Size;
use whitted::observer::Stats;
use whitted_sim::scene_file::Buffer;

use crate::args::{DisplayOptions, Gallery, Passes};
use crate::draw::{Drawing, draw};
use crate::open::{Scene, all_scenes};
use crate::outcome::Outcome;
use crate::report;
use page::Entry;
use sheet::Sheet;

/// Renders scenes into a directory.
pub(crate) fn gallery(options: &Gallery) -> Outcome {
    let Gallery {
        scenes,
        output,
        size,
    } = options;
    let scenes = match scenes[..] {
        [] => &all_scenes()?,
        _ => scenes,
    };
    let names = names(scenes)?;
    fs::create_dir_all(output)
        .map_err(|error| format!("{}: cannot be created: {error}", output.display()))?;
    let mut sheet = Sheet::new(scenes.len(), *size);
    let mut entries = Vec::new();
    for (path, name) in scenes.iter().zip(names) {
        let scene = Scene::open(path)?;
        let drawing = render(&scene, *size)?;
        let file = format!("{name}.png");
        report::save(&drawing.image, &output.join(&file))?;
        sheet.add(&drawing.image)?;
        entries.push(Entry {
            title: scene.title().unwrap_or(&name).to_owned(),
            file,
            rays: rays(&drawing.work.stats),
        });
    }
    report::save(&sheet.image(), &output.join(sheet::FILE))?;
    let index = output.join("index.html");
    fs::write(&index, page::page(&entries, *size))
        .map_err(|error| format!("{}: cannot be written: {error}", index.display()))?;
    report::wrote(&index);
    Ok(())
}

fn render(scene: &Scene, size: Size) -> Outcome<Drawing> {
    let mut buffer = Box::new(Buffer::new());
    let prepared = scene.prepare(&mut buffer)?;
    draw(
        &prepared,
        size,
        DisplayOptions::default(),
        Passes::default(),
    )
}

fn rays(stats: &Stats) -> u64 {
    let Stats {
        camera,
        reflected,
        transmitted,
        shadow,
        ..
    } = *stats;
    [camera, reflected, transmitted, shadow]
        .map(u64::from)
        .iter()
        .sum()
}

/// Returns the names of the pictures, or an error if two scenes have the same name.
fn names(scenes: &[PathBuf]) -> Outcome<Vec<String>> {
    let mut names = Vec::new();
    for path in scenes {
        let stem = path.file_stem().unwrap_or(path.as_os_str());
        let name = stem.to_string_lossy().into_owned();
        if names.contains(&name) || Path::new(sheet::FILE).file_stem() == Some(stem) {
            let help = "remove it from the command line, or rename the file";
            let reason = format!("the name `{name}.png` is already taken");
            return Err(format!("{}: {reason}\n  help: {help}", path.display()).into());
        }
        names.push(name);
    }
    Ok(names)
}
