use std::ops::Range;

use super::error::LoadError;

/// Text of a scene file, with the offsets of its lines. The offsets convert the place of an error to
/// a line number.
pub(super) struct Source<'a> {
    /// File name in error messages.
    pub(super) name: &'a str,
    pub(super) text: &'a str,
    /// Byte offset of each line end.
    line_ends: Vec<usize>,
}

impl<'a> Source<'a> {
    pub(super) fn new(name: &'a str, text: &'a str) -> Self {
        let line_ends = text.match_indices('\n').map(|(offset, _)| offset);
        Self {
            name,
            text,
            line_ends: line_ends.collect(),
        }
    }

    /// Returns the line of a byte offset, counted from 1.
    pub(super) fn line(&self, offset: usize) -> usize {
        1 + self.line_ends.partition_point(|end| *end < offset)
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
}
