//! `sim gallery`: renders scenes to PNGs, and writes an HTML page and a contact sheet that show
//! them.

mod page;
mod sheet;
mod thumbnail;

use std::fs;
use std::path::{Path, PathBuf};

use whitted::observer::Stats;
use whitted_sim::scene_file::Buffer;

use crate::args::Gallery;
use crate::console::Console;
use crate::draw::{Drawing, Settings, draw};
use crate::open::{Scene, all_scenes, find, stem};
use crate::outcome::Outcome;
use crate::output::{FileType, Output, write_png};
use crate::report;
use page::Entry;
use sheet::Sheet;

/// File name of the HTML page.
const PAGE: &str = "index.html";

/// Renders scenes into a directory.
pub(crate) fn gallery(options: &Gallery) -> Outcome {
    let scenes = match options.scenes[..] {
        [] => &all_scenes()?,
        _ => &options.scenes,
    };
    let directory = &options.output;
    let names = names(scenes)?;
    let scenes: Vec<_> = scenes
        .iter()
        .map(|scene| find(scene))
        .collect::<Outcome<_>>()?;
    check_outputs(directory, &names, &scenes)?;
    let settings = Settings::new(options.size, options.display_options, options.edges);
    let size = settings.display.size;
    let mut sheet = Sheet::new(scenes.len(), size);
    let mut entries = Vec::new();
    for (path, name) in scenes.iter().zip(names) {
        let scene = Scene::read(path)?;
        let file = format!("{name}.png");
        let output = directory.join(&file);
        let png = Output::create(&output, &FileType::PNG, &scenes)?;
        let drawing = render(&scene, &settings)?;
        write_png(&drawing.image, png)?;
        report::wrote(Console::Stdout, &output)?;
        sheet.add(&drawing.image, drawing.transfer)?;
        entries.push(Entry {
            title: scene.title().unwrap_or(&name).to_owned(),
            comment: scene.comment().unwrap_or_default().to_owned(),
            file,
            scene: path.clone(),
            is_animated: scene.is_animated(),
            rays: rays(&drawing.work.stats),
        });
    }
    let output = directory.join(sheet::FILE);
    let png = Output::create(&output, &FileType::PNG, &scenes)?;
    write_png(&sheet.image(), png)?;
    report::wrote(Console::Stdout, &output)?;
    let output = directory.join(PAGE);
    let html = Output::create(&output, &FileType::HTML, &scenes)?;
    let page = page::page(&entries, size);
    html.write(|file| Ok(file.write_all(page.as_bytes())?))?;
    report::wrote(Console::Stdout, &output)
}

/// Creates the directory, and checks all files before the first picture is rendered.
fn check_outputs(directory: &Path, names: &[String], scenes: &[PathBuf]) -> Outcome {
    fs::create_dir_all(directory)
        .map_err(|error| format!("{}: cannot be created: {error}", directory.display()))?;
    for name in names {
        let picture = directory.join(format!("{name}.png"));
        Output::check(&picture, &FileType::PNG, scenes)?;
    }
    Output::check(&directory.join(sheet::FILE), &FileType::PNG, scenes)?;
    Output::check(&directory.join(PAGE), &FileType::HTML, scenes)?;
    Ok(())
}

fn render(scene: &Scene, settings: &Settings) -> Outcome<Drawing> {
    let mut buffer = Box::new(Buffer::new());
    let prepared = scene.prepare(&mut buffer)?;
    draw(&prepared, settings, 1)
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
        let scene = find(path)?;
        let stem = stem(&scene);
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
