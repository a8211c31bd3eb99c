use std::ops::Range;

use toml::Spanned;
use toml::de::DeTable;

use super::error::LoadError;

/// Text of a scene file. The text is needed to convert the byte offset of an error to a line
/// number.
pub(super) struct Source<'a> {
    /// File name in error messages.
    pub(super) name: &'a str,
    pub(super) text: &'a str,
}

impl<'a> Source<'a> {
    /// Returns the line of a byte offset, counted from 1.
    pub(super) fn line(&self, offset: usize) -> usize {
        let before = self.text.as_bytes().iter().take(offset);
        1 + before.filter(|byte| **byte == b'\n').count()
    }

    /// Returns an error about `key`, whose byte range in the file is given. If `key` is empty, the
    /// message names no key.
    pub(super) fn error(
        &self,
        place: &Range<usize>,
        key: &str,
        reason: impl Into<String>,
    ) -> LoadError {
        LoadError {
            file: self.name.to_owned(),
            line: Some(self.line(place.start)),
            key: (!key.is_empty()).then(|| key.to_owned()),
            reason: reason.into(),
            help: None,
        }
    }

    /// Parses the text as TOML.
    pub(super) fn table(&self) -> Result<Spanned<DeTable<'a>>, LoadError> {
        DeTable::parse(self.text).map_err(|error| self.syntax_error(&error))
    }

    fn syntax_error(&self, error: &toml::de::Error) -> LoadError {
        let place = error.span().unwrap_or_default();
        if error.message() == "duplicate key" {
            let key = self.text.get(place.clone()).unwrap_or_default();
            return self
                .error(&place, key, "is defined twice")
                .help("remove or rename one of the two");
        }
        let rest = self.text.get(place.start..).unwrap_or_default();
        let found = match rest.lines().next() {
            Some("") | None => "the end of the line".to_owned(),
            Some(found) => format!("`{found}`"),
        };
        self.error(&place, "", format!("{}, found {found}", error.message()))
            .help("a scene is written in TOML: `key = value` lines under [table] headings")
    }
}
