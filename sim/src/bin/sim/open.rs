//! Finds and reads scene files and compiled scenes.

use std::ffi::OsStr;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use whitted::{DecodeError, PreparedScene, Real, SceneError};
use whitted_sim::input;
use whitted_sim::scene_file::{self, Buffer, LoadError, SceneFile};

use crate::args::Quality;
use crate::outcome::Outcome;

/// Path that names stdin.
const STDIN: &str = "-";

/// A scene file or a compiled scene.
pub(crate) enum Scene {
    /// A scene file in TOML.
    File(Box<SceneFile>),
    /// Output of `sim compile`.
    Compiled { name: String, bytes: Vec<u8> },
}

impl Scene {
    /// Opens a scene by its path or by its name in scenes/.
    pub(crate) fn open(path: &Path) -> Outcome<Self> {
        Self::read(&find(path)?)
    }

    /// Reads a scene from a file. If the file name does not end in .toml, the content decides
    /// whether the file is a scene file or a compiled scene.
    pub(crate) fn read(path: &Path) -> Outcome<Self> {
        if path == Path::new(STDIN) {
            let bytes = input::read_from(io::stdin());
            let bytes = bytes.map_err(|error| format!("stdin: cannot be read: {error}"))?;
            return Self::parse("stdin".to_owned(), bytes);
        }
        let name = path.display().to_string();
        if path
            .extension()
            .is_some_and(|extension| extension == "toml")
        {
            return Ok(Self::file(scene_file::load(path)?));
        }
        let bytes =
            input::read(path).map_err(|error| format!("{name}: cannot be read: {error}"))?;
        Self::parse(name, bytes)
    }

    fn parse(name: String, bytes: Vec<u8>) -> Outcome<Self> {
        // Text without the signature of a compiled scene is parsed as TOML.
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

    /// Prepares the scene for rendering.
    pub(crate) fn prepare<'b>(&'b self, buffer: &'b mut Buffer) -> Outcome<PreparedScene<'b>> {
        match self {
            Self::File(file) => Ok(file.prepare(buffer)?),
            Self::Compiled { name, bytes } => {
                let scene = buffer.decode(bytes);
                scene.map_err(|error| undecodable(name, error).into())
            }
        }
    }

    /// Prepares the scene for rendering, and applies the limits of the ray tree from the command
    /// line.
    pub(crate) fn prepare_for<'b>(
        &'b self,
        quality: &Quality,
        buffer: &'b mut Buffer,
    ) -> Outcome<PreparedScene<'b>> {
        let mut scene = self.prepare(buffer)?;
        apply_overrides(&mut scene, quality)?;
        Ok(scene)
    }

    /// Checks frames over the whole animation, if the scene has one.
    pub(crate) fn check_frames(&self) -> Outcome {
        match self {
            Self::File(file) => Ok(file.check_frames()?),
            Self::Compiled { .. } => Ok(()),
        }
    }

    /// Returns warnings about parts of the scene that have no effect. Compiled scenes have no
    /// warnings, because they have no lines and names.
    pub(crate) fn warnings(&self, prepared: &PreparedScene<'_>) -> Vec<LoadError> {
        match self {
            Self::File(file) => file.warnings(prepared),
            Self::Compiled { .. } => Vec::new(),
        }
    }

    /// Compiles the scene and its animation to the binary format.
    pub(crate) fn compile(&self) -> Outcome<Vec<u8>> {
        match self {
            Self::File(file) => Ok(file.compile()?),
            Self::Compiled { name, bytes } => match Buffer::new().decode_animation(bytes) {
                Ok(_) => Ok(bytes.clone()),
                Err(error) => Err(undecodable(name, error).into()),
            },
        }
    }

    /// Converts an error that the library reports for the frame at `time`.
    pub(crate) fn explain_frame(&self, error: SceneError, time: Real) -> String {
        match self {
            Self::File(file) => file.explain_frame(error, time).to_string(),
            Self::Compiled { name, .. } => format!("{name}: at {time:.3} s, {error}"),
        }
    }

    /// Returns the title of the scene, if it has one.
    pub(crate) fn title(&self) -> Option<&str> {
        match self {
            Self::File(file) => file.title.as_deref(),
            Self::Compiled { .. } => None,
        }
    }

    /// Returns the comment at the top of the scene file, if it has one.
    pub(crate) fn comment(&self) -> Option<&str> {
        match self {
            Self::File(file) => file.comment.as_deref(),
            Self::Compiled { .. } => None,
        }
    }

    /// Returns true if the scene has an animation.
    pub(crate) fn is_animated(&self) -> bool {
        matches!(self, Self::File(file) if file.animation.is_some())
    }

    /// Returns the type and material of an object, or `None` if the scene is compiled. Compiled
    /// scenes have no names.
    pub(crate) fn describe(&self, object: u16) -> Option<String> {
        match self {
            Self::File(file) => file.describe(object),
            Self::Compiled { .. } => None,
        }
    }
}

/// If the command line sets limits of the ray tree, replaces the scene's limits.
pub(crate) fn apply_overrides(scene: &mut PreparedScene<'_>, quality: &Quality) -> Outcome {
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

fn undecodable(name: &str, error: DecodeError) -> String {
    format!("{name}: {error}\n  help: recompile it with `cargo sim compile SCENE -o FILE`")
}

fn decode(bytes: &[u8]) -> Result<(), DecodeError> {
    Buffer::new().decode(bytes).map(drop)
}

/// Returns the root of the project and its folder of scenes.
fn project_folders() -> [PathBuf; 2] {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent();
    let root = root.unwrap_or(Path::new("."));
    [root.to_owned(), root.join("scenes")]
}

/// Returns the paths of the scenes in scenes/, sorted by name.
pub(crate) fn all_scenes() -> Outcome<Vec<PathBuf>> {
    let [_, scenes] = project_folders();
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

/// Returns the name of the files that a command makes of a scene: the file name of the scene
/// without its extension.
pub(crate) fn stem(scene: &Path) -> &OsStr {
    match scene == Path::new(STDIN) {
        true => OsStr::new("stdin"),
        false => scene.file_stem().unwrap_or(scene.as_os_str()),
    }
}

/// Finds a scene: `-` for stdin, the path itself, the path relative to the project's root, or a file or name in
/// scenes/.
pub(crate) fn find(path: &Path) -> Outcome<PathBuf> {
    if path == Path::new(STDIN) {
        return Ok(path.to_owned());
    }
    let [root, scenes] = project_folders();
    let mut named = scenes.join(path).into_os_string();
    named.push(".toml");
    let candidates = [
        path.to_owned(),
        root.join(path),
        scenes.join(path),
        named.into(),
    ];
    if let Some(found) = candidates
        .into_iter()
        .find(|path| path.exists() && !path.is_dir())
    {
        return Ok(found);
    }
    Err(format!("{}: no such scene{}", path.display(), help(path)).into())
}

/// Returns the help text for an unknown scene. The text suggests the scene with the most similar
/// name, or lists all scenes if no name is similar.
fn help(path: &Path) -> String {
    let stem = |path: &Path| Some(path.file_stem()?.to_str()?.to_owned());
    let scenes = all_scenes().unwrap_or_default();
    let names: Vec<_> = scenes.iter().filter_map(|path| stem(path)).collect();
    let wanted = stem(path).unwrap_or_default();
    match scene_file::nearest(&wanted, names.iter().map(String::as_str)) {
        Some(name) => format!("\n  help: did you mean `scenes/{name}.toml`?"),
        None if names.is_empty() => String::new(),
        None => format!("\n  help: the scenes in scenes/ are {}", names.join(", ")),
    }
}
