use toml::de::{DeTable, DeValue};

use super::source::Source;

/// Stores the lines and values of all keys of a scene file. Errors that are found after the file
/// was read need them.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    name: String,
    entries: Vec<Entry>,
}

/// A key of a scene file, with its line number and its value. The value is written as in the file,
/// but on one line. A long value is cut, because the text of a table contains the text of its keys.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) path: String,
    pub(super) text: String,
    pub(super) line: usize,
}

impl Outline {
    pub(super) fn new(source: &Source<'_>, table: &DeTable<'_>) -> Self {
        let mut entries = Vec::new();
        walk_table(source, table, "", &mut entries);
        entries.sort_by_key(|entry| entry.line);
        let name = source.name.to_owned();
        Self { name, entries }
    }

    /// Returns the entry of the key with this path.
    pub(super) fn find(&self, path: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.path == path)
    }

    /// Returns the file name for error messages.
    pub(super) fn name(&self) -> &str {
        &self.name
    }
}

fn walk_table(source: &Source<'_>, table: &DeTable<'_>, path: &str, entries: &mut Vec<Entry>) {
    for (key, node) in table.iter() {
        let path = match path {
            "" => key.get_ref().to_string(),
            path => format!("{path}.{}", key.get_ref()),
        };
        walk(source, node, path, entries);
    }
}

fn walk(
    source: &Source<'_>,
    node: &toml::Spanned<DeValue<'_>>,
    path: String,
    entries: &mut Vec<Entry>,
) {
    match node.get_ref() {
        DeValue::Table(table) => walk_table(source, table, &path, entries),
        DeValue::Array(nodes) => {
            for (index, node) in nodes.iter().enumerate() {
                walk(source, node, format!("{path}[{index}]"), entries);
            }
        }
        _ => {}
    }
    let text = source.text.get(node.span()).unwrap_or_default();
    entries.push(Entry {
        path,
        text: one_line(text),
        line: source.line(node.span().start),
    });
}

/// Replaces all white space by single spaces, and cuts the text after about 100 bytes.
fn one_line(text: &str) -> String {
    const LENGTH: usize = 100;
    let mut line = String::new();
    for word in text.split_whitespace() {
        if !line.is_empty() {
            line.push(' ');
        }
        line.extend(word.chars().take(LENGTH));
        if line.len() >= LENGTH {
            break;
        }
    }
    line
}
