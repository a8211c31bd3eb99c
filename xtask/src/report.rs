//! Parses the lines that firmware prints.

use std::fmt;

use anyhow::{Context, Result, bail};

/// A report: the lines `key: value` that firmware has printed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Report(Vec<String>);

impl Report {
    /// Creates a report from these lines.
    pub fn new(lines: Vec<String>) -> Self {
        Self(lines)
    }

    /// Returns the report, or an error if it is empty or has the key `error`.
    pub fn result(&self) -> Result<&Self> {
        match self.get("error") {
            Ok(error) => bail!("the firmware reports: {error}"),
            Err(_) if self.0.is_empty() => bail!("the firmware printed no report"),
            Err(_) => Ok(self),
        }
    }

    /// Returns all lines of the report.
    pub(crate) fn lines(&self) -> &[String] {
        &self.0
    }

    /// Returns the value of a key in the report.
    pub fn get(&self, key: &str) -> Result<&str> {
        self.0
            .iter()
            .find_map(|line| line.strip_prefix(key)?.strip_prefix(": "))
            .with_context(|| format!("no {key:?} in the report:\n{self}"))
    }

    /// Returns the value of a key in the report as a number.
    pub fn number(&self, key: &str) -> Result<u64> {
        let value = self.get(key)?;
        value.parse().with_context(|| format!("{key}: {value}"))
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|line| writeln!(f, "{line}"))
    }
}
