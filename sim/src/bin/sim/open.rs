//! Finds a scene and reads it, whichever of its two forms it has.

use std::fs;
use std::path::{Path, PathBuf};

use whitted::{DecodeError, PreparedScene};
use whitted_sim::scene_file::{self, Buffer, SceneFile};

use crate::args::Quality;
use crate::outcome::Outcome;

/// A scene as it was found.
pub(crate) enum Scene {
    /// Written by a person.
    File(Box<SceneFile>),
    /// Written by `sim compile`.
    Compiled { name: String, bytes: Vec<u8> },
}

impl Scene {
    /// Opens a path, or else what the project's scenes have by this name.
    pub(crate) fn open(path: &Path) -> Outcome<Self> {
        Self::read(&find(path)?)
    }

    /// Reads the file of a scene.
    pub(crate) fn read(path: &Path) -> Outcome<Self> {
        let name = path.display().to_string();
        if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            return Ok(Self::file(scene_file::load(path)?));
        }
        let bytes = fs::read(path).map_err(|error| format!("{name}: cannot be read: {error}"))?;
        // Anything that does not claim to be compiled is taken for text.
        match (decode(&bytes), std::str::from_utf8(&bytes)) {
            (Err(DecodeError::NotAScene), Ok(text)) => {
                Ok(Self::file(scene_file::parse(&name, text)?))
            }
            _ => Ok(Self::Compiled { name, bytes }),
        }
    }

    fn file(file: SceneFile) -> Self {
        Self::File(Box::new(file))
    }

    /// The scene ready to be rendered.
    pub(crate) fn prepare<'b>(&'b self, buffer: &'b mut Buffer) -> Outcome<PreparedScene<'b>> {
        match self {
            Self::File(file) => Ok(file.prepare(buffer)?),
            Self::Compiled { name, bytes } => {
                let help = "compile it anew with `cargo sim compile SCENE -o FILE`";
                let scene = buffer.decode(bytes);
                scene.map_err(|error| format!("{name}: {error}\n  help: {help}").into())
            }
        }
    }

    /// The scene ready to be rendered, with the options that overrule it.
    pub(crate) fn prepare_for<'b>(
        &'b self,
        quality: &Quality,
        buffer: &'b mut Buffer,
    ) -> Outcome<PreparedScene<'b>> {
        let mut scene = self.prepare(buffer)?;
        overrule(&mut scene, quality)?;
        Ok(scene)
    }

    /// The scene in its compact form.
    pub(crate) fn compile(&self) -> Outcome<Vec<u8>> {
        let mut buffer = Box::new(Buffer::new());
        let prepared = self.prepare(&mut buffer)?;
        let mut bytes = vec![0; prepared.encoded_len()];
        let length = prepared.encode(&mut bytes).unwrap_or_default();
        bytes.truncate(length);
        Ok(bytes)
    }

    /// What the scene calls itself.
    pub(crate) fn title(&self) -> Option<&str> {
        match self {
            Self::File(file) => file.title.as_deref(),
            Self::Compiled { .. } => None,
        }
    }

    /// More of an object than its number, if the scene knows more.
    pub(crate) fn describe(&self, object: u16) -> Option<String> {
        match self {
            Self::File(file) => file.describe(object),
            Self::Compiled { .. } => None,
        }
    }
}

/// Sets what the options say in place of the scene.
pub(crate) fn overrule(scene: &mut PreparedScene<'_>, quality: &Quality) -> Outcome {
    if let Some(max_depth) = quality.max_depth {
        let set = scene.set_max_depth(max_depth);
        set.map_err(|error| format!("--max-depth {max_depth}: {}", error.problem))?;
    }
    if let Some(min_weight) = quality.min_weight {
        let set = scene.set_min_weight(min_weight);
        set.map_err(|error| format!("--min-weight {min_weight}: {}", error.problem))?;
    }
    Ok(())
}

fn decode(bytes: &[u8]) -> Result<(), DecodeError> {
    Buffer::new().decode(bytes).map(drop)
}

/// The project's root, and the scenes in it.
fn places() -> [PathBuf; 2] {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent();
    let root = root.unwrap_or(Path::new("."));
    [root.to_owned(), root.join("scenes")]
}

/// The project's scenes, by name.
pub(crate) fn all_scenes() -> Outcome<Vec<PathBuf>> {
    let [_, scenes] = places();
    let entries = fs::read_dir(&scenes)
        .map_err(|error| format!("{}: cannot be read: {error}", scenes.display()))?;
    let mut paths = Vec::new();
    for entry in entries {
        paths.push(entry?.path());
    }
    paths.retain(|path| {
        path.extension()
            .is_some_and(|extension| extension == "toml")
    });
    paths.sort();
    Ok(paths)
}

/// The path itself; or the same seen from the project's root; or a scene of
/// that name in scenes/.
pub(crate) fn find(path: &Path) -> Outcome<PathBuf> {
    let [root, scenes] = places();
    let mut named = scenes.join(path).into_os_string();
    named.push(".toml");
    let places = [
        path.to_owned(),
        root.join(path),
        scenes.join(path),
        named.into(),
    ];
    if let Some(found) = places
        .into_iter()
        .find(|place| place.exists() && !place.is_dir())
    {
        return Ok(found);
    }
    Err(format!("{}: no such scene{}", path.display(), advice(path)).into())
}

/// Names the scene that was most likely meant.
fn advice(path: &Path) -> String {
    let stem = |path: &Path| Some(path.file_stem()?.to_str()?.to_owned());
    let scenes = all_scenes().unwrap_or_default();
    let names: Vec<_> = scenes.iter().filter_map(|path| stem(path)).collect();
    let wanted = stem(path).unwrap_or_default();
    match scene_file::nearest(&wanted, names.iter().map(String::as_str)) {
        Some(name) => format!("\n  help: did you mean `scenes/{name}.toml`?"),
        None if names.is_empty() => String::new(),
        None => format!("\n  help: scenes/ has {}", names.join(", ")),
    }
}
