//! `sim new`: writes a scene to start with.

use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use crate::console::Console;
use crate::outcome::Outcome;

const SCENE: &[u8] = include_bytes!("new/scene.toml");

/// Writes a scene file with comments. An existing file is not changed.
pub(crate) fn new(name: &Path) -> Outcome {
    let path = with_extension(name);
    let shown = path.display();
    let mut file = File::create_new(&path).map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => {
            format!("{shown}: already exists\n  help: choose another name, or remove the file")
        }
        _ => format!("{shown}: cannot be written: {error}"),
    })?;
    file.write_all(SCENE).map_err(|error| {
        // A part of a scene is of no use. The error of the file is the one that matters.
        _ = fs::remove_file(&path);
        format!("{shown}: cannot be written: {error}")
    })?;
    Ok(writeln!(
        Console::Stdout,
        "wrote {shown}; render it with `cargo sim render {shown}`"
    )?)
}

/// Appends the extension of scene files if a name lacks it. The rest of the name may have dots.
fn with_extension(name: &Path) -> PathBuf {
    if name
        .extension()
        .is_some_and(|extension| extension == "toml")
    {
        return name.to_owned();
    }
    let mut name = name.as_os_str().to_owned();
    name.push(".toml");
    name.into()
}
