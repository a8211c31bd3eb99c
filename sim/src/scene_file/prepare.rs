use whitted::PreparedScene;

use super::error::LoadError;
use super::file::{Buffer, SceneFile};

impl SceneFile {
    /// Prepares the scene.
    ///
    /// # Errors
    /// Returns the line and key of the first value that the library rejects.
    pub fn prepare<'b>(&'b self, buffer: &'b mut Buffer) -> Result<PreparedScene<'b>, LoadError> {
        buffer
            .prepare(&self.scene())
            .map_err(|error| self.explain(error))
    }

    /// Compiles the scene and its animation. [`whitted::SceneBuffer::decode_animation`] reads the
    /// bytes.
    ///
    /// # Errors
    /// Returns the line and key of the first value that the library rejects.
    pub fn compile(&self) -> Result<Vec<u8>, LoadError> {
        let mut buffer = Box::new(Buffer::new());
        let Some(animation) = &self.animation else {
            let scene = self.prepare(&mut buffer)?;
            return Ok(written(scene.encoded_len(), |out| scene.encode(out)));
        };
        animation.with_animation(|animation| {
            let animation = buffer
                .prepare_animation(&self.scene(), animation)
                .map_err(|error| self.explain_animation(error))?;
            Ok(written(animation.encoded_len(), |out| {
                animation.encode(out)
            }))
        })
    }

    /// Prepares frames over the whole animation, if the scene has one: at 256 times with equal
    /// distances, and at 1024 keyframes of each track or at all of them.
    ///
    /// # Errors
    /// Returns the line and key of the first keyframe whose value, or a value after it, is rejected.
    pub fn check_frames(&self) -> Result<(), LoadError> {
        let Some(animation) = &self.animation else {
            return Ok(());
        };
        let compiled = self.compile()?;
        let mut buffer = Box::new(Buffer::new());
        let frames = buffer.decode_animation(&compiled);
        let mut frames = frames.map_err(|error| self.error_at(String::new(), error.to_string()))?;
        for time in animation.sample_times() {
            frames
                .frame(time)
                .map_err(|error| self.explain_frame(error, time))?;
        }
        Ok(())
    }

    /// Checks the animation's duration, keyframe times and targets.
    pub(super) fn check_animation(&self) -> Result<(), LoadError> {
        let Some(animation) = &self.animation else {
            return Ok(());
        };
        animation
            .with_animation(|animation| animation.check(&self.scene()))
            .map_err(|error| self.explain_animation(error))
    }
}

/// Allocates `length` bytes and writes to them.
fn written(length: usize, write: impl FnOnce(&mut [u8]) -> Option<usize>) -> Vec<u8> {
    let mut bytes = vec![0; length];
    let written = write(&mut bytes).unwrap_or_default();
    bytes.truncate(written);
    bytes
}
