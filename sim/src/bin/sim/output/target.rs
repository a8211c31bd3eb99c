//! Finds out what the path of an output names.

use std::fs;
use std::io::{self, ErrorKind, IsTerminal};
use std::path::{Path, PathBuf};

use super::identity::names_stdout;
use crate::outcome::Outcome;

/// The place that a path names.
pub(crate) enum Target {
    /// The path is `-`, or a name of the file or pipe that stdout writes to.
    Stdout,
    /// A pipe or a device, which is written in place.
    Stream(PathBuf),
    /// A file that exists or that can be created. The path contains no links, so that a rename
    /// replaces the file and not a link.
    File(PathBuf),
}

impl Target {
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        if is_stdout(path) {
            return Ok(Self::Stdout);
        }
        match fs::metadata(path) {
            Ok(found) if found.is_dir() => Err(ErrorKind::IsADirectory.into()),
            Ok(found) if found.is_file() => fs::canonicalize(path).map(Self::File),
            Ok(_) => Ok(Self::Stream(path.to_owned())),
            Err(error) if error.kind() == ErrorKind::NotFound => new_file(path).map(Self::File),
            Err(error) => Err(error),
        }
    }
}

/// Returns true if a path names stdout.
pub(crate) fn is_stdout(path: &Path) -> bool {
    path == Path::new("-") || names_stdout(path)
}

/// Returns true if a path names stdout, a pipe or a device. Such an output needs no file name
/// extension.
pub(crate) fn is_stream(path: &Path) -> bool {
    !matches!(Target::of(path), Ok(Target::File(_)) | Err(_))
}

/// Returns an error if stdout is a terminal, which cannot show the bytes of a file.
pub(super) fn refuse_terminal() -> Outcome {
    if io::stdout().is_terminal() {
        let help = "redirect it to a file or a pipe, or write a file with `-o FILE`";
        return Err(format!("stdout: the output is not text\n  help: {help}").into());
    }
    Ok(())
}

/// Returns the path of a missing file without links. The path itself may be a link to the missing
/// file.
fn new_file(path: &Path) -> io::Result<PathBuf> {
    let directory = match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    if let Ok(link) = fs::read_link(path) {
        return new_file(&directory.join(link));
    }
    let name = path.file_name().ok_or(ErrorKind::IsADirectory)?;
    Ok(fs::canonicalize(directory)?.join(name))
}
