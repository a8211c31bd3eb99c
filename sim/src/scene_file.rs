//! Reads scene files (TOML) into a [`whitted::Scene`].
//!
//! The reader checks the names of scene-file keys, the types of values, and references to names.
//! The library checks the values when it prepares the scene. [`SceneFile::explain`] finds the line
//! and scene-file key of a value that the library rejects. `docs/scenes.md` documents the format.
//!
//! The reader does not use serde, because serde's tagged enums lose the positions of values. Errors
//! would then have no line numbers. The reader uses `DeTable`, which keeps the position of each
//! value.

mod alias;
mod animation;
mod comment;
mod counts;
mod error;
mod example;
mod explain;
mod explain_animation;
mod file;
mod file_animation;
mod inside;
mod keyframe;
mod light;
mod material;
mod name;
mod object;
mod outline;
mod prepare;
mod read;
mod schema;
mod shape;
mod shape_reader;
mod source;
mod suggest;
mod syntax;
mod table;
mod target;
mod texture;
mod value;
mod warning;
mod warning_light;

use std::io::{Error, ErrorKind};
use std::path::Path;

use crate::input;

pub use error::LoadError;
pub use file::{Buffer, SceneFile};
pub use file_animation::FileAnimation;
pub use schema::TableSchema;
pub use suggest::nearest;

/// Reads a scene file.
pub fn load(path: impl AsRef<Path>) -> Result<SceneFile, LoadError> {
    let path = path.as_ref();
    let name = path.display().to_string();
    let text = input::read(path).and_then(|bytes| {
        String::from_utf8(bytes).map_err(|error| Error::new(ErrorKind::InvalidData, error))
    });
    parse(
        &name,
        &text.map_err(|error| LoadError::unreadable(&name, error))?,
    )
}

/// Reads a scene from the text of a scene file. Error messages contain `name` as the file name.
pub fn parse(name: &str, text: &str) -> Result<SceneFile, LoadError> {
    read::scene_file(&source::Source::new(name, text))
}

/// Reads a scene file and compiles it. See [`SceneFile::compile`].
pub fn compile(path: impl AsRef<Path>) -> Result<Vec<u8>, LoadError> {
    load(path)?.compile()
}

/// Lists the tables of the scene-file format. Each entry has the scene-file keys that the table
/// accepts.
///
/// An object accepts the keys of its type and those of the table "an object".
pub fn tables() -> Vec<TableSchema> {
    use schema::{
        ANIMATION, BACKGROUND, BOUNDS, CAMERA, CHECKER, LIGHT, MATERIAL, OBJECT, SCENE, TRACK,
    };
    let mut tables = vec![
        SCENE, CAMERA, BACKGROUND, LIGHT, MATERIAL, OBJECT, CHECKER, BOUNDS, ANIMATION, TRACK,
    ];
    tables.extend(shape::SHAPES.map(|shape| shape.schema));
    tables
}
