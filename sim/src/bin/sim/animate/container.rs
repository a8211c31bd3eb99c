use std::path::Path;

use crate::args::Container;
use crate::outcome::Outcome;
use crate::output::{extension, is_stream};

/// Returns the container of an animation, or `None` for numbered PNGs in a directory.
///
/// The file name shows the container. Stdout, pipes and devices need no file name, so the user
/// chooses the container.
pub(super) fn container(output: &Path, chosen: Option<Container>) -> Outcome<Option<Container>> {
    let extension = extension(output);
    let named = match extension.as_deref() {
        Some("gif") => Some(Container::Gif),
        Some("apng" | "png") => Some(Container::Apng),
        _ => None,
    };
    if is_stream(output) {
        return Ok(chosen.or(named).or(Some(Container::Gif)));
    }
    let path = output.display();
    if extension.is_none() || is_directory(output) {
        return match chosen {
            None => Ok(None),
            Some(_) => Err(format!(
                "{path}: a directory has no `--container`\n  help: write FILE.gif or FILE.apng"
            )
            .into()),
        };
    }
    match (named, chosen) {
        (None, _) => Err(format!(
            "{path}: unknown animation format\n  help: write FILE.gif, FILE.apng, or DIR/ for numbered PNGs"
        )
        .into()),
        (Some(named), Some(chosen)) if named != chosen => Err(format!(
            "{path}: `--container` differs from the file name\n  help: leave out `--container`"
        )
        .into()),
        _ => Ok(named),
    }
}

/// Returns true if a path names a directory, which exists or ends with a slash.
fn is_directory(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().to_string_lossy().ends_with('/')
}
