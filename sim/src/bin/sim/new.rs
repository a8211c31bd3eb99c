//! `sim new`: writes a scene to start with.

use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

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
    file.write_all(SCENE)
        .map_err(|error| format!("{shown}: cannot be written: {error}"))?;
    println!("wrote {shown}; render it with `cargo sim render {shown}`");
    Ok(())
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
