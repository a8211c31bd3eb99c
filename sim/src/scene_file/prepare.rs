use whitted::{PreparedScene, Real, Scene};

use super::error::LoadError;
use super::file::{AnimatedScene, Buffer, SceneFile};

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

    /// Returns the scene at a time of its animation, in seconds. If the file has no table
    /// `[animation]`, the scene is returned unchanged.
    ///
    /// # Errors
    /// Returns the line and key of the first track that the library rejects.
    pub fn frame<'s>(
        &'s self,
        buffer: &'s mut AnimatedScene,
        time: Real,
    ) -> Result<Scene<'s>, LoadError> {
        let Some(animation) = &self.animation else {
            return Ok(self.scene());
        };
        animation
            .with_animation(|animation| buffer.frame(&self.scene(), animation, time))
            .map_err(|error| self.explain_animation(error))
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
        let mut animated = Box::new(AnimatedScene::new());
        let mut buffer = Box::new(Buffer::new());
        for time in animation.sample_times() {
            let scene = self.frame(&mut animated, time)?;
            buffer
                .prepare(&scene)
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
