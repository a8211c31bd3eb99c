use std::path::{Path, PathBuf};

use crate::open::{self, Scene};
use crate::outcome::Outcome;

/// A scene file that is reloaded when the file changes.
pub(super) struct Source {
    pub(super) path: PathBuf,
    /// Compiled form of the last version of the file that was a valid scene.
    compiled: Option<Vec<u8>>,
    /// Error in the current version of the file, if any.
    error: Option<String>,
}

impl Source {
    /// Finds the scene file without reading it.
    pub(super) fn find(path: &Path) -> Outcome<Self> {
        Ok(Self {
            path: open::find(path)?,
            compiled: None,
            error: None,
        })
    }

    /// Reads the scene file again. If the file has an error, the last valid scene stays.
    pub(super) fn read(&mut self) {
        let compiled = Scene::read(&self.path).and_then(|scene| scene.compile());
        match compiled {
            Ok(compiled) => {
                self.compiled = Some(compiled);
                self.error = None;
            }
            Err(error) => self.error = Some(self.shortened(&error.to_string())),
        }
    }

    /// Returns the last valid scene as a compiled scene, or `None` if the file has had an error
    /// every time.
    pub(super) fn compiled(&self) -> Option<&[u8]> {
        self.compiled.as_deref()
    }

    /// Returns the error in the current version of the file.
    pub(super) fn error(&self) -> Option<&str> {
        self.error.as_deref()
    }

    /// Returns the name of the scene file without its extension.
    pub(super) fn name(&self) -> String {
        let stem = self.path.file_stem().unwrap_or(self.path.as_os_str());
        stem.to_string_lossy().into_owned()
    }

    /// Shortens the path of the file in a message to the file name.
    fn shortened(&self, message: &str) -> String {
        let name = self.path.file_name().unwrap_or_default().to_string_lossy();
        message.replacen(&self.path.display().to_string(), &name, 1)
    }
}
