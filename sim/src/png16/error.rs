use std::error::Error;
use std::fmt;
use std::path::Path;

use crate::text::escaped;

/// Error while reading or writing a PNG, with the file's path.
#[derive(Debug)]
pub struct PngError {
    path: String,
    error: Box<dyn Error + Send + Sync>,
}

impl PngError {
    pub(super) fn new(path: &Path, error: impl Into<Box<dyn Error + Send + Sync>>) -> Self {
        let path = path.display().to_string();
        let error = error.into();
        Self { path, error }
    }
}

impl fmt::Display for PngError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let error = self.error.to_string();
        write!(f, "{}: {}", escaped(&self.path), escaped(&error))
    }
}

impl Error for PngError {}
