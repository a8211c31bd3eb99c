use std::path::{Path, PathBuf};

use whitted_sim::scene_file::Buffer;

use crate::open::{self, Scene};
use crate::outcome::Outcome;

/// A scene file that is reloaded when the file changes.
pub(super) struct Source {
    pub(super) path: PathBuf,
    /// Last version of the file that was a valid scene.
    scene: Option<Scene>,
    /// Error in the current version of the file, if any.
    error: Option<String>,
}

impl Source {
    /// Finds the scene file without reading it.
    pub(super) fn find(path: &Path) -> Outcome<Self> {
        Ok(Self {
            path: open::find(path)?,
            scene: None,
            error: None,
        })
    }

    /// Reads the scene file again. If the file has an error, the last valid scene stays.
    pub(super) fn read(&mut self, buffer: &mut Buffer) {
        let scene = Scene::read(&self.path).and_then(|scene| {
            scene.prepare(buffer)?;
            Ok(scene)
        });
        match scene {
            Ok(scene) => {
                self.scene = Some(scene);
                self.error = None;
            }
            Err(error) => self.error = Some(self.shortened(&error.to_string())),
        }
    }

    /// Returns the last valid scene, or `None` if the file has had an error every time.
    pub(super) fn scene(&self) -> Option<&Scene> {
        self.scene.as_ref()
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
