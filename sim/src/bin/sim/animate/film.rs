use std::path::Path;

use crate::outcome::Outcome;

/// Writes the frames of an animation to a file, in order.
pub(super) trait Film {
    /// Adds the next frame. Each pixel has three bytes in `pixels`: red, green and blue.
    fn add(&mut self, pixels: &[u8]) -> Outcome;

    /// Completes the animation's file.
    fn finish(self: Box<Self>) -> Outcome;
}

/// Returns the message for a file that cannot be written.
pub(super) fn unwritable(path: &Path, error: impl std::fmt::Display) -> String {
    format!("{}: cannot be written: {error}", path.display())
}
