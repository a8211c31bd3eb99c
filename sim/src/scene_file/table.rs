//! Reads the keys of one TOML table.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::alias::alias;
use super::error::LoadError;
use super::example::example;
use super::schema::{SCENE, TableSchema};
use super::source::Source;
use super::suggest::{quoted_list, suggestion};
use super::value::Value;

/// A TOML table whose keys are checked against a schema.
pub(super) struct Table<'a> {
    source: &'a Source<'a>,
    /// Path of the table, such as `objects[1]`. The path of the top level is empty.
    path: String,
    /// Name of the table with its article, as error messages print it, such as "a light".
    name: &'static str,
    /// Byte range of the table's heading.
    heading: Range<usize>,
    entries: &'a DeTable<'a>,
}

impl<'a> Table<'a> {
    /// Opens the top level of a scene file.
    pub(super) fn root(
        source: &'a Source<'a>,
        entries: &'a DeTable<'a>,
    ) -> Result<Self, LoadError> {
        let table = Self {
            source,
            path: String::new(),
            name: SCENE.name,
            heading: 0..0,
            entries,
        };
        table.reject_unknown(SCENE.name, SCENE.keys)?;
        Ok(table)
    }

    /// Opens a value as a table. Returns an error if the value is not a table, or if the schema
    /// lacks one of its keys.
    pub(super) fn open(value: &Value<'a>, schema: TableSchema) -> Result<Self, LoadError> {
        let table = Self::open_any(value, "a table", schema.name)?;
        table.reject_unknown(schema.name, schema.keys)?;
        Ok(table)
    }

    /// Opens a value as a table without checking its keys. If the value has another type, the error
    /// message says that `expected` is needed.
    pub(super) fn open_any(
        value: &Value<'a>,
        expected: &str,
        name: &'static str,
    ) -> Result<Self, LoadError> {
        let DeValue::Table(entries) = value.node.get_ref() else {
            return Err(value.wrong_type(expected));
        };
        Ok(Self {
            source: value.source,
            path: value.path.clone(),
            name,
            heading: value.node.span(),
            entries,
        })
    }

    /// Sets the name of the table in error messages.
    pub(super) fn named(self, name: &'static str) -> Self {
        Self { name, ..self }
    }

    /// Returns an error for the first key that is not in `known`.
    ///
    /// Call this function before reading required keys. If a required key is misspelled, two errors
    /// are possible: the right key is missing, and the misspelled key is unknown. Only the error
    /// for the unknown key shows the misspelling.
    pub(super) fn reject_unknown(
        &self,
        name: &str,
        known: &[&'static str],
    ) -> Result<(), LoadError> {
        let unknown = self
            .entries
            .keys()
            .filter(|key| !known.contains(&key.get_ref().as_ref()));
        let Some(key) = unknown.min_by_key(|key| key.span().start) else {
            return Ok(());
        };
        let path = self.child(key.get_ref());
        let reason = format!("{name} has no such key");
        let help = self.unknown_key_help(key.get_ref(), name, known);
        Err(self.source.error(&key.span(), &path, reason).help(help))
    }

    fn unknown_key_help(&self, key: &str, name: &str, known: &[&'static str]) -> String {
        if let Some(right) = alias(name, known, key) {
            return format!("did you mean `{right}`?");
        }
        if !self.path.is_empty() && SCENE.keys.contains(&key) {
            return format!("`{key}` belongs to the scene: write it above the first [table]");
        }
        let keys_are = format!("the keys of {name} are");
        let known = known.iter().copied();
        // If an example exists for the key, another table accepts the key. The key is then
        // misplaced, not misspelled.
        if example(key).is_empty() {
            suggestion(key, known, &keys_are)
        } else {
            format!("{keys_are} {}", quoted_list(known))
        }
    }

    /// Returns the value of an optional key.
    pub(super) fn get(&self, key: &'static str) -> Option<Value<'a>> {
        let node = self.entries.get(key)?;
        Some(Value {
            source: self.source,
            path: self.child(key),
            key,
            node,
        })
    }

    /// Returns the value of a required key.
    pub(super) fn need(&self, key: &'static str) -> Result<Value<'a>, LoadError> {
        self.get(key).ok_or_else(|| self.missing(key, self.name))
    }

    /// Returns the error for a missing key. `who` names the table or type that requires the key.
    pub(super) fn missing(&self, key: &str, who: &str) -> LoadError {
        let reason = format!("missing: {who} needs it");
        self.source
            .error(&self.heading, &self.child(key), reason)
            .help(format!("add `{}`", example(key)))
    }

    /// Returns all keys and values of the table, in the file's order.
    pub(super) fn entries(&self) -> Vec<(&'a str, Value<'a>)> {
        let mut entries: Vec<_> = self.entries.iter().collect();
        entries.sort_by_key(|(key, _)| key.span().start);
        let entry = |(key, node): (&'a toml::Spanned<_>, _)| {
            let key = AsRef::<str>::as_ref(key.get_ref());
            let value = Value {
                source: self.source,
                path: self.child(key),
                key,
                node,
            };
            (key, value)
        };
        entries.into_iter().map(entry).collect()
    }

    fn child(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.to_owned()
        } else {
            format!("{}.{key}", self.path)
        }
    }
}
