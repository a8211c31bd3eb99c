//! Finds the modules of a crate, and the dependencies between these modules.

use std::collections::BTreeMap;
use std::path::Path;

use super::names::{ModulePath, Names, Use};
use super::source::Source;

/// Largest number of re-exports that are followed to find the definition of an item.
const MAX_DEPTH: usize = 16;

/// The modules of a crate. The keys of the map are module paths. The root module has an empty path.
pub(super) struct Crate<'s> {
    pub(super) modules: BTreeMap<ModulePath, Module<'s>>,
}

pub(super) struct Module<'s> {
    pub(super) source: &'s Source,
    names: Names,
}

/// A module that a file depends on.
pub(super) struct Dependency {
    pub(super) module: ModulePath,
    pub(super) line: usize,
}

impl<'s> Crate<'s> {
    /// Collects the modules of the crate in a folder. If the folder has a `lib.rs`, leaves out
    /// `main.rs` and the folder `bin`, because they are separate crates.
    pub(super) fn new(folder: &str, sources: &'s [Source]) -> Self {
        let library = Path::new(folder).join("lib.rs");
        let has_library = sources.iter().any(|source| source.path == library);
        let mut modules = BTreeMap::new();
        for source in sources {
            let Ok(inside) = source.path.strip_prefix(folder) else {
                continue;
            };
            let inside = inside.with_extension("");
            if has_library && (inside == Path::new("main") || inside.starts_with("bin")) {
                continue;
            }
            let names = inside.iter().map(|name| name.display().to_string());
            let mut path: ModulePath = names.collect();
            path.pop_if(|last| ["lib", "main", "mod"].contains(&last.as_str()));
            let names = Names::of(source);
            modules.insert(path, Module { source, names });
        }
        Self { modules }
    }

    /// Returns the other modules that a module depends on. It depends on a module if it imports an
    /// item of this module, or mentions the item by a path. The import by a re-export counts only
    /// if the file also mentions the imported name.
    pub(super) fn dependencies(&self, module: &ModulePath) -> Vec<Dependency> {
        let Some(Module { names, .. }) = self.modules.get(module) else {
            return Vec::new();
        };
        let mut paths = Vec::new();
        for import in &names.uses {
            let Some(target) = self.absolute(module, &import.path) else {
                continue;
            };
            if !import.is_public || names.mentioned.contains(&import.name) {
                paths.push((target, import.line));
            }
        }
        for (path, line) in &names.paths {
            let alias = names.uses.iter().find(|import| import.name == path[0]);
            let absolute = self.absolute(module, path).or_else(|| {
                let target = self.absolute(module, &alias?.path)?;
                Some([&target, &path[1..]].concat())
            });
            paths.extend(absolute.map(|absolute| (absolute, *line)));
        }
        let resolved = paths.into_iter().filter_map(|(path, line)| {
            let module = self.resolve(&path, 0)?;
            Some(Dependency { module, line })
        });
        let others = resolved.filter(|used| used.module != *module);
        others.collect()
    }

    /// Converts a path in the source code of `module` to a path from the root of the crate. Returns
    /// `None` if the path leads to another crate.
    fn absolute(&self, module: &ModulePath, path: &[String]) -> Option<ModulePath> {
        let (first, rest) = path.split_first()?;
        match first.as_str() {
            "crate" => Some(rest.to_vec()),
            "self" => Some([module, rest].concat()),
            "super" => {
                let (_, parent) = module.split_last()?;
                match rest.first().map(String::as_str) {
                    Some("super") => self.absolute(&parent.to_vec(), rest),
                    _ => Some([parent, rest].concat()),
                }
            }
            child => {
                let inner = [&module[..], &[child.to_owned()]].concat();
                let is_child = self.modules.contains_key(&inner);
                is_child.then(|| [&inner, rest].concat())
            }
        }
    }

    /// Returns the module that defines the item at a path. Returns `None` if the path leads to a
    /// module instead of an item.
    fn resolve(&self, path: &[String], depth: usize) -> Option<ModulePath> {
        let mut module = ModulePath::new();
        for (index, name) in path.iter().enumerate() {
            let inner = [&module, std::slice::from_ref(name)].concat();
            if self.modules.contains_key(&inner) {
                module = inner;
                continue;
            }
            let import = self.import(&module, name, depth);
            let target = import.and_then(|import| {
                let target = self.absolute(&module, &import.path)?;
                let item = if import.name == "*" { index } else { index + 1 };
                Some([&target, &path[item..]].concat())
            });
            return match target {
                Some(target) if depth < MAX_DEPTH => self.resolve(&target, depth + 1),
                _ => Some(module),
            };
        }
        None
    }

    /// Returns the `use` declaration by which a module imports a name. Returns `None` if the module
    /// defines the name itself or does not import it.
    fn import(&self, module: &ModulePath, name: &str, depth: usize) -> Option<&Use> {
        let names = &self.modules.get(module)?.names;
        if names.items.contains(name) || depth >= MAX_DEPTH {
            return None;
        }
        let mut uses = names.uses.iter();
        uses.clone().find(|import| import.name == name).or_else(|| {
            uses.find(|import| {
                let target = self.absolute(module, &import.path);
                import.name == "*"
                    && target.is_some_and(|target| self.provides(&target, name, depth + 1))
            })
        })
    }

    /// Returns true if a module defines or imports a name.
    fn provides(&self, module: &ModulePath, name: &str, depth: usize) -> bool {
        let found = self.modules.get(module);
        found.is_some_and(|found| found.names.items.contains(name))
            || self.import(module, name, depth).is_some()
    }
}
