//! The paths inside the crate that a file names.

use std::collections::BTreeSet;

use crate::tidy::module_of;
use crate::tidy::tokens::Source;

/// A path from the crate's root on.
pub(super) type Path = Vec<String>;

/// A path that a file names, in a `use` or anywhere.
#[derive(Debug)]
pub(super) struct Import {
    /// What the file calls it; `*` for all that is there.
    pub(super) name: String,
    pub(super) path: Path,
    /// The token where the path ends.
    pub(super) token: usize,
    /// Whether others may have it from here.
    pub(super) is_public: bool,
    /// Whether this file uses it itself.
    pub(super) is_used: bool,
}

/// All paths that a file names, given the paths of all modules.
pub(super) fn imports(source: &Source, modules: &BTreeSet<Path>) -> Vec<Import> {
    let mut reader = Reader {
        source,
        modules,
        module: module_of(&source.path),
        imports: Vec::new(),
    };
    let mut used = BTreeSet::new();
    let mut at = 0;
    while at < source.tokens.len() {
        // `use<'a>` is a bound.
        if source.text(at) == "use" && source.text(at + 1) != "<" {
            // `pub use`, or `pub(super) use`.
            let is_public = source.before(at, 1) == "pub" || source.before(at, 4) == "pub";
            at = reader.tree(at + 1, &Path::new(), is_public);
        } else if reader.source.is_path(at + 1)
            && ["crate", "super", "self"].contains(&source.text(at))
        {
            at = reader.tree(at, &Path::new(), false);
        } else {
            used.insert(source.text(at));
            at += 1;
        }
    }
    for import in &mut reader.imports {
        import.is_used = used.contains(import.name.as_str());
    }
    reader.imports
}

impl Source {
    /// Whether `::` stands here.
    fn is_path(&self, at: usize) -> bool {
        self.text(at) == ":" && self.text(at + 1) == ":"
    }
}

struct Reader<'s> {
    source: &'s Source,
    modules: &'s BTreeSet<Path>,
    /// The module that the file is.
    module: Path,
    imports: Vec<Import>,
}

impl Reader<'_> {
    /// Reads a path or a tree of paths, of which `before` is read already, and
    /// returns where it ends.
    fn tree(&mut self, mut at: usize, before: &Path, is_public: bool) -> usize {
        if self.source.text(at) == "{" {
            at += 1;
            while !["}", ""].contains(&self.source.text(at)) {
                at = self.tree(at, before, is_public);
                at += usize::from(self.source.text(at) == ",");
            }
            return at + 1;
        }
        let mut path = before.clone();
        path.push(self.source.text(at).to_owned());
        if self.source.is_path(at + 1) {
            return self.tree(at + 3, &path, is_public);
        }
        let renamed = self.source.text(at + 1) == "as";
        self.add(
            path,
            renamed.then(|| self.source.text(at + 2)),
            at,
            is_public,
        );
        at + if renamed { 3 } else { 1 }
    }

    /// Adds a path as it is written, unless it leads out of the crate.
    fn add(&mut self, mut path: Path, name: Option<&str>, token: usize, is_public: bool) {
        // `tracer::{self}` is the module, `tracer::*` is for what is in it.
        let last = path.pop_if(|last| last == "self" || last == "*");
        let own = path.last().cloned().unwrap_or_default();
        let name = match (name, last.as_deref()) {
            (Some(name), _) => name.to_owned(),
            (None, Some("*")) => "*".to_owned(),
            (None, _) => own,
        };
        if let Some(path) = self.absolute(&path) {
            self.imports.push(Import {
                name,
                path,
                token,
                is_public,
                is_used: false,
            });
        }
    }

    fn absolute(&self, path: &[String]) -> Option<Path> {
        let (first, rest) = path.split_first()?;
        let mut absolute = self.module.clone();
        match first.as_str() {
            "crate" => absolute.clear(),
            "self" => {}
            "super" => {
                absolute.pop();
                let ups = rest.iter().take_while(|name| *name == "super").count();
                absolute.truncate(absolute.len().saturating_sub(ups));
                return Some([&absolute, &rest[ups..]].concat());
            }
            // A module inside of this one, or another crate.
            child => {
                absolute.push(child.to_owned());
                if !self.modules.contains(&absolute) {
                    return None;
                }
            }
        }
        absolute.extend_from_slice(rest);
        Some(absolute)
    }
}
