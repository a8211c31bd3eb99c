use std::path::Path;

use crate::outcome::Outcome;

/// Writer of the frames of an animation, in order.
pub(super) trait Film {
    /// Adds the next frame: red, green and blue of each pixel.
    fn add(&mut self, pixels: &[u8]) -> Outcome;

    /// Finishes the file.
    fn finish(self: Box<Self>) -> Outcome;
}

/// Returns the message for a file that cannot be written.
pub(super) fn unwritable(path: &Path, error: impl std::fmt::Display) -> String {
    format!("{}: cannot be written: {error}", path.display())
}
