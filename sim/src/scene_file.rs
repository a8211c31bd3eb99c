//! Scene files: TOML in, [`whitted::Scene`] out.
//!
//! Reading checks the form: keys, types, names. Values are checked where a
//! scene is prepared; [`SceneFile::prepare`] and [`SceneFile::explain`] lead
//! that error back to its line. The file is walked as a `DeTable`, whose spans
//! give each error a line, which serde's tagged enums would lose.

mod animation;
mod error;
mod example;
mod explain;
mod file;
mod keys;
mod light;
mod material;
mod motion;
mod name;
mod nearest;
mod object;
mod outline;
mod read;
mod shape;
mod source;
mod target;
mod texture;
mod value;

use std::path::Path;

pub use error::LoadError;
pub use file::{Buffer, SceneFile};
pub use motion::{Motion, Stage};
pub use nearest::nearest;

/// Reads a scene file.
pub fn load(path: impl AsRef<Path>) -> Result<SceneFile, LoadError> {
    let path = path.as_ref();
    let name = path.display().to_string();
    let text =
        std::fs::read_to_string(path).map_err(|error| LoadError::unreadable(&name, error))?;
    parse(&name, &text)
}

/// Reads a scene file's text; errors call the file `name`.
pub fn parse(name: &str, text: &str) -> Result<SceneFile, LoadError> {
    read::scene_file(&source::Source { name, text })
}

/// Reads a scene file and encodes it for [`whitted::SceneBuffer::decode`].
pub fn compile(path: impl AsRef<Path>) -> Result<Vec<u8>, LoadError> {
    let file = load(path)?;
    let mut buffer = Box::new(Buffer::new());
    let prepared = file.prepare(&mut buffer)?;
    let mut bytes = vec![0; prepared.encoded_len()];
    let length = prepared.encode(&mut bytes).unwrap_or_default();
    bytes.truncate(length);
    Ok(bytes)
}
