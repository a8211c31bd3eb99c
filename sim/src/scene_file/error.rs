use std::error::Error;
use std::fmt;
use std::io;

use crate::text::{escaped, excerpt};

/// An error in a scene file. It has the place and the reason of the error, and may have advice.
///
/// [`Display`](fmt::Display) escapes characters that control a terminal. The key and the quoted parts
/// of the file are shortened to 60 characters.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadError {
    /// File name as the caller passed it.
    pub file: String,
    /// Line number of the error, counted from 1. It is `None` if the error concerns the whole file.
    pub line: Option<usize>,
    /// Path of the scene-file key, such as `objects[1].radius`.
    pub key: Option<String>,
    /// Reason of the error. In the error message, the reason follows the scene-file key.
    pub reason: String,
    /// Advice on how to fix the error.
    pub help: Option<String>,
}

impl LoadError {
    /// Returns the error for a file that cannot be read.
    pub(super) fn unreadable(file: &str, error: io::Error) -> Self {
        let help = match error.kind() {
            io::ErrorKind::InvalidData => "save the scene file as UTF-8 text",
            io::ErrorKind::FileTooLarge => "remove objects and keyframes, or check the path",
            _ => "check the path and its permissions",
        };
        Self {
            file: file.to_owned(),
            line: None,
            key: None,
            reason: format!("cannot be read: {error}"),
            help: Some(help.to_owned()),
        }
    }

    /// Sets the advice of the error.
    pub(super) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&escaped(&self.file))?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        if let Some(key) = &self.key {
            write!(f, ": {}", excerpt(key))?;
        }
        write!(f, ": {}", escaped(&self.reason))?;
        match &self.help {
            Some(help) => write!(f, "\n  help: {}", escaped(help)),
            None => Ok(()),
        }
    }
}

impl Error for LoadError {}
