//! Collects the names that a file defines, imports and mentions.

use std::collections::BTreeSet;

use super::source::Source;

/// Segments of a path, such as `crate`, `math`, `Real`.
pub(super) type ModulePath = Vec<String>;

/// Keywords that precede the name of an item.
const ITEMS: [&str; 8] = [
    "const", "enum", "fn", "static", "struct", "trait", "type", "union",
];

/// A `use` declaration of one name.
pub(super) struct Use {
    /// Name that the declaration introduces in this file, or `*`.
    pub(super) name: String,
    /// Imported path as written, without a final `*` or `self`.
    pub(super) path: ModulePath,
    pub(super) is_public: bool,
    pub(super) line: usize,
}

#[derive(Default)]
pub(super) struct Names {
    /// Names of the items that are defined outside of blocks.
    pub(super) items: BTreeSet<String>,
    pub(super) uses: Vec<Use>,
    /// Paths outside of `use` declarations, with their line numbers. Each path has at least two
    /// segments.
    pub(super) paths: Vec<(ModulePath, usize)>,
    /// Contains the first segment of each path, and all identifiers outside of paths.
    pub(super) mentioned: BTreeSet<String>,
}

impl Names {
    pub(super) fn of(source: &Source) -> Self {
        let mut names = Self::default();
        let (mut at, mut depth) = (0, 0);
        while at < source.tokens.len() {
            match source.text(at) {
                "{" => depth += 1,
                "}" => depth -= 1,
                // `use<'a>` is a bound of a type, not an import.
                "use" if source.text(at + 1) != "<" => {
                    let before = |distance| at.checked_sub(distance).map(|at| source.text(at));
                    // The import is public if it is `pub use` or `pub(crate) use`.
                    let is_public = before(1) == Some("pub")
                        || before(1) == Some(")") && before(4) == Some("pub");
                    at = names.read_use(source, at + 1, &[], is_public);
                    continue;
                }
                keyword if ITEMS.contains(&keyword) && depth == 0 => {
                    names.items.insert(source.text(at + 1).to_owned());
                }
                "macro_rules" => {
                    names.items.insert(source.text(at + 2).to_owned());
                }
                text => {
                    names.mentioned.insert(text.to_owned());
                    if source.text(at + 1) == "::" {
                        at = names.read_path(source, at);
                    }
                }
            }
            at += 1;
        }
        names
    }

    /// Reads the path that starts at the token with index `start`. Returns the index of the last
    /// token of the path.
    fn read_path(&mut self, source: &Source, start: usize) -> usize {
        let mut path = vec![source.text(start).to_owned()];
        let mut at = start;
        while source.text(at + 1) == "::" && is_identifier(source.text(at + 2)) {
            path.push(source.text(at + 2).to_owned());
            at += 2;
        }
        self.paths.push((path, source.tokens[start].line));
        at
    }

    /// Reads a tree of imports in a `use` declaration. Its imported paths begin with `prefix`.
    /// Returns the index of the token after the tree.
    fn read_use(
        &mut self,
        source: &Source,
        mut at: usize,
        prefix: &[String],
        is_public: bool,
    ) -> usize {
        if source.text(at) == "{" {
            at += 1;
            while !["}", ""].contains(&source.text(at)) {
                at = self.read_use(source, at, prefix, is_public);
                at += usize::from(source.text(at) == ",");
            }
            return at + 1;
        }
        let segment = source.text(at).to_owned();
        if source.text(at + 1) == "::" {
            let prefix = [prefix, &[segment]].concat();
            return self.read_use(source, at + 2, &prefix, is_public);
        }
        let path = match segment.as_str() {
            "*" | "self" => prefix.to_vec(),
            _ => [prefix, std::slice::from_ref(&segment)].concat(),
        };
        let is_renamed = source.text(at + 1) == "as";
        let name = match segment.as_str() {
            _ if is_renamed => source.text(at + 2).to_owned(),
            "*" => segment,
            _ => path.last().cloned().unwrap_or_default(),
        };
        self.uses.push(Use {
            name,
            path,
            is_public,
            line: source.tokens.get(at).map_or(0, |token| token.line),
        });
        at + if is_renamed { 3 } else { 1 }
    }
}

fn is_identifier(text: &str) -> bool {
    text.starts_with(|first: char| first.is_alphabetic() || first == '_')
}
