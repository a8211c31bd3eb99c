use std::path::{Path, PathBuf};

use whitted_sim::scene_file::Buffer;

use crate::open::{self, Scene};
use crate::outcome::Outcome;

/// A scene's file, and what was read from it.
pub(super) struct Source {
    pub(super) path: PathBuf,
    /// What could be read last.
    scene: Option<Scene>,
    /// What is wrong with the file as it is now.
    error: Option<String>,
}

impl Source {
    /// A scene that there is; it is not read yet.
    pub(super) fn find(path: &Path) -> Outcome<Self> {
        Ok(Self {
            path: open::find(path)?,
            scene: None,
            error: None,
        })
    }

    /// Reads the file. If something is wrong with it, the scene stays as it was.
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

    /// The scene, if the file was fine once.
    pub(super) fn scene(&self) -> Option<&Scene> {
        self.scene.as_ref()
    }

    /// What is wrong with the file.
    pub(super) fn error(&self) -> Option<&str> {
        self.error.as_deref()
    }

    /// What the scene is called.
    pub(super) fn name(&self) -> String {
        let stem = self.path.file_stem().unwrap_or(self.path.as_os_str());
        stem.to_string_lossy().into_owned()
    }

    /// A message that names the file without the directory.
    fn shortened(&self, message: &str) -> String {
        let name = self.path.file_name().unwrap_or_default().to_string_lossy();
        message.replacen(&self.path.display().to_string(), &name, 1)
    }
}
