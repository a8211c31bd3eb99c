use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Result;
use embedded_graphics_core::geometry::Size;

use super::crowd::crowd;
use super::generator;
use super::room::room;
use crate::{root, scratch_dir};

/// A picture to learn from.
#[derive(Clone, Debug)]
pub(super) struct Subject {
    pub(super) name: String,
    pub(super) file: PathBuf,
    pub(super) size: Size,
    /// Whether it is one of the project's scenes, which matter most.
    pub(super) is_shipped: bool,
}

/// How many random scenes of each kind.
const RANDOM: u64 = 64;

/// The project's scenes, again as pictures of many and short lines, some of them as ones so
/// small that decoding shows, and random ones, which tell apart what goes together in the
/// others: things of all kinds, rooms, and crowds.
pub(super) fn all() -> Result<Vec<Subject>> {
    let mut subjects = Vec::new();
    for (size, is_shipped) in [(Size::new(160, 120), true), (Size::new(8, 120), false)] {
        for file in shipped()? {
            subjects.push(subject(&file, size, is_shipped));
        }
    }
    for name in ["whitted", "every_surface"] {
        let file = root().join("scenes").join(name).with_extension("toml");
        subjects.push(subject(&file, Size::new(8, 6), false));
    }
    for seed in 0..RANDOM {
        let things = whole_shininess(&generator::scene(seed).toml);
        for (kind, toml) in [
            ("things", things),
            ("room", room(seed)),
            ("crowd", crowd(seed)),
        ] {
            let file = scratch_dir()?.join(format!("random_{kind}_{seed}.toml"));
            fs::write(&file, toml)?;
            subjects.push(subject(&file, Size::new(40, 30), false));
        }
    }
    Ok(subjects)
}

fn subject(file: &Path, size: Size, is_shipped: bool) -> Subject {
    Subject {
        name: file.file_stem().unwrap_or_default().display().to_string(),
        file: file.to_owned(),
        size,
        is_shipped,
    }
}

fn shipped() -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(root().join("scenes"))? {
        files.push(entry?.path());
    }
    files.retain(|file| file.extension().is_some_and(|is| is == "toml"));
    files.sort();
    Ok(files)
}

/// A shininess of many binary places costs a root for each, and nobody writes
/// one.
fn whole_shininess(toml: &str) -> String {
    let line = |line: &str| match line.split_once('.') {
        Some((whole, _)) if line.starts_with("shininess") => format!("{whole}\n"),
        _ => format!("{line}\n"),
    };
    toml.lines().map(line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_shininess_is_cut() {
        let toml = "ks = [0.5, 0.5, 0.5]\nshininess = 12.75\n";
        assert_eq!(
            whole_shininess(toml),
            "ks = [0.5, 0.5, 0.5]\nshininess = 12\n"
        );
    }
}
