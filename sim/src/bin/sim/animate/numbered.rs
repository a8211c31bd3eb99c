use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use super::frames::Frames;
use crate::console::Console;
use crate::outcome::Outcome;
use crate::output::{FileType, Output, write_png};

/// Writes each frame of an animation to a PNG with a number: `frame-0000.png`, `frame-0001.png` and
/// so on. Then removes the frames of an earlier, longer animation.
pub(super) fn write(directory: &Path, inputs: &[PathBuf], frames: &mut Frames<'_>) -> Outcome {
    fs::create_dir_all(directory)
        .map_err(|error| format!("{}: cannot be created: {error}", directory.display()))?;
    let digits = frames.count().to_string().len().max(4);
    let names = (0..frames.count()).map(|index| format!("frame-{index:0digits$}.png"));
    let names: Vec<_> = names.collect();
    for name in &names {
        Output::check(&directory.join(name), &FileType::PNG, inputs)?;
    }
    for (index, name) in names.iter().enumerate() {
        let output = Output::create(&directory.join(name), &FileType::PNG, inputs)?;
        write_png(&frames.draw(index)?, output)?;
    }
    remove_others(directory, &names.into_iter().collect())
}

/// Removes the numbered PNGs that do not belong to the animation.
fn remove_others(directory: &Path, names: &BTreeSet<String>) -> Outcome {
    let unreadable = |error| format!("{}: cannot be read: {error}", directory.display());
    let mut count = 0;
    for entry in fs::read_dir(directory).map_err(unreadable)? {
        let entry = entry.map_err(unreadable)?;
        let name = entry.file_name().to_string_lossy().into_owned();
        if is_frame(&name) && !names.contains(&name) {
            let path = entry.path();
            fs::remove_file(&path)
                .map_err(|error| format!("{}: cannot be removed: {error}", path.display()))?;
            count += 1;
        }
    }
    if count > 0 {
        writeln!(
            Console::Stdout,
            "removed {count} other frames from {}",
            directory.display()
        )?;
    }
    Ok(())
}

/// Returns true for the file name of a frame.
fn is_frame(name: &str) -> bool {
    let number = name.strip_prefix("frame-");
    let number = number.and_then(|rest| rest.strip_suffix(".png"));
    number.is_some_and(|number| {
        number.len() >= 4 && number.bytes().all(|digit| digit.is_ascii_digit())
    })
}
