use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::error::LoadError;
use super::example::example;
use super::nearest::{advice, list};
use super::source::Source;
use super::value::Value;

/// A kind of table, and the keys that it may have.
#[derive(Clone, Copy)]
pub(super) struct Kind {
    /// With its article: "a light".
    pub(super) name: &'static str,
    pub(super) keys: &'static [&'static str],
}

/// A whole scene file.
pub(super) const SCENE: Kind = Kind {
    name: "a scene",
    keys: &[
        "title",
        "max_depth",
        "min_weight",
        "shading",
        "ambient",
        "background",
        "camera",
        "lights",
        "materials",
        "objects",
        "animation",
    ],
};

/// A table of the file.
#[derive(Clone)]
pub(super) struct Keys<'a> {
    pub(super) source: &'a Source<'a>,
    /// `objects[1]`; empty for the file itself.
    pub(super) path: String,
    /// Its heading.
    pub(super) place: Range<usize>,
    pub(super) table: &'a DeTable<'a>,
}

impl<'a> Keys<'a> {
    /// The keys of a value that must be a table, called `what`.
    pub(super) fn of(value: &Value<'a>, what: &str) -> Result<Self, LoadError> {
        let DeValue::Table(table) = value.node.get_ref() else {
            return Err(value.wrong(what));
        };
        Ok(Self {
            source: value.source,
            path: value.path.clone(),
            place: value.node.span(),
            table,
        })
    }

    /// An error if there is a key that this kind of table does not have. It
    /// comes before any search for missing keys, as a misspelt key is both.
    pub(super) fn only(&self, kind: Kind) -> Result<(), LoadError> {
        let unknown = self
            .table
            .keys()
            .filter(|key| !kind.keys.contains(&key.get_ref().as_ref()));
        let Some(key) = unknown.min_by_key(|key| key.span().start) else {
            return Ok(());
        };
        let name = key.get_ref().as_ref();
        let help = if !self.path.is_empty() && SCENE.keys.contains(&name) {
            format!("`{name}` belongs to the scene: write it above the first [table]")
        } else {
            let keys = kind.keys.iter().copied();
            let these_are = format!("the keys of {} are", kind.name);
            // The key of another kind is not misspelt, but out of place.
            match example(name) {
                "" => advice(name, keys, &these_are),
                _ => format!("{these_are} {}", list(keys)),
            }
        };
        let reason = format!("{} has no such key", kind.name);
        Err(self
            .source
            .error(&key.span(), &self.child(name), reason)
            .help(help))
    }

    /// The value of a key, if it is there.
    pub(super) fn get(&self, key: &'static str) -> Option<Value<'a>> {
        self.table.get(key).map(|node| Value {
            source: self.source,
            path: self.child(key),
            key,
            node,
        })
    }

    /// The value of a key that must be there, since `who` needs it.
    pub(super) fn need(&self, key: &'static str, who: &str) -> Result<Value<'a>, LoadError> {
        self.get(key).ok_or_else(|| self.missing(key, who))
    }

    /// The error that a key is not there, though `who` needs it.
    pub(super) fn missing(&self, key: &str, who: &str) -> LoadError {
        self.source
            .error(
                &self.place,
                &self.child(key),
                format!("missing: {who} needs it"),
            )
            .help(format!("add `{}`", example(key)))
    }

    /// All entries, in the file's order.
    pub(super) fn entries(&self) -> Vec<(&'a str, Value<'a>)> {
        let mut entries: Vec<_> = self.table.iter().collect();
        entries.sort_by_key(|(key, _)| key.span().start);
        let value = |key: &'a str, node| Value {
            source: self.source,
            path: self.child(key),
            key,
            node,
        };
        entries
            .into_iter()
            .map(|(key, node)| (key.get_ref().as_ref(), value(key.get_ref(), node)))
            .collect()
    }

    fn child(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }
}
