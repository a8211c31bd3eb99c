use std::error::Error;
use std::fmt;
use std::io;

/// What is wrong with a scene file, where, and how to mend it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LoadError {
    /// The file's name, as it was given.
    pub file: String,
    /// The line, counted from 1; none where the file as a whole is meant.
    pub line: Option<usize>,
    /// The key, for example `objects[1].radius`.
    pub key: Option<String>,
    /// What is wrong.
    pub reason: String,
    /// What would be right.
    pub help: Option<String>,
}

impl LoadError {
    /// The file could not be read at all.
    pub(super) fn unreadable(file: &str, error: io::Error) -> Self {
        let help = match error.kind() {
            io::ErrorKind::InvalidData => "a scene file is text in UTF-8",
            _ => "check the path",
        };
        Self {
            file: file.to_owned(),
            line: None,
            key: None,
            reason: format!("cannot be read: {error}"),
            help: Some(help.to_owned()),
        }
    }

    /// The same error with advice.
    pub(super) fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.file)?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        if let Some(key) = &self.key {
            write!(f, ": {key}")?;
        }
        write!(f, ": {}", self.reason)?;
        match &self.help {
            Some(help) => write!(f, "\n  help: {help}"),
            None => Ok(()),
        }
    }
}

impl Error for LoadError {}
