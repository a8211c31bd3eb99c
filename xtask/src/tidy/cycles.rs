//! Finds import cycles: files that depend on each other.

use std::collections::{BTreeMap, BTreeSet};

use super::modules::Crate;
use super::names::ModulePath;

/// Maps each module of a crate to the modules that it depends on.
type Graph = BTreeMap<ModulePath, BTreeSet<ModulePath>>;

/// Returns a violation for each import cycle.
pub(super) fn check(modules: &Crate) -> Vec<String> {
    let mut graph = Graph::new();
    for module in modules.modules.keys() {
        let used = modules.dependencies(module).into_iter();
        graph.insert(module.clone(), used.map(|used| used.module).collect());
    }
    let mut violations = Vec::new();
    while let Some(cycle) = find(graph.clone()) {
        let file = |module| modules.modules[module].source.path.display().to_string();
        let files: Vec<_> = cycle.iter().map(file).collect();
        violations.push(format!("import cycle: {}", files.join(" -> ")));
        // Removes the first dependency of this cycle, so that the next search finds another cycle.
        if let (Some(used), [first, ..]) = (graph.get_mut(&cycle[0]), &cycle[1..]) {
            used.remove(first);
        }
    }
    violations
}

/// Finds an import cycle and returns its modules. The first module is also the last one.
fn find(mut graph: Graph) -> Option<Vec<ModulePath>> {
    // Repeatedly removes modules without dependencies in the graph, because they are in no cycle.
    loop {
        let rest: BTreeSet<_> = graph.keys().cloned().collect();
        graph.retain(|_, used| !used.is_disjoint(&rest));
        if graph.len() == rest.len() {
            break;
        }
    }
    // Every remaining module depends on another one. Therefore, a walk from module to dependency
    // reaches a module twice, and so finds a cycle.
    let mut module = graph.keys().next()?;
    let mut walk = Vec::new();
    while !walk.contains(module) {
        walk.push(module.clone());
        module = graph[module]
            .iter()
            .find(|used| graph.contains_key(*used))?;
    }
    let start = walk.iter().position(|passed| passed == module)?;
    let mut cycle = walk.split_off(start);
    cycle.push(module.clone());
    Some(cycle)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::source::parse_all;

    fn violations(files: &[(&str, &str)]) -> anyhow::Result<Vec<String>> {
        let root = ("src/lib.rs", "mod a; mod b; pub use a::*;");
        let sources = parse_all(&[&[root], files].concat())?;
        Ok(check(&Crate::new("src", &sources)))
    }

    #[test]
    fn finds_cycles_through_any_kind_of_path() -> anyhow::Result<()> {
        for text in [
            "use crate::a::A;",
            "use crate::A as B;",
            "use super::{a::{A}};",
            "use crate::a; fn f() { g(a::A) }",
            "fn f() -> crate::a::A {}",
            "fn f() { println!(\"{}\", crate::a::A) }",
        ] {
            let a = ("src/a.rs", "use crate::b::f; struct A;");
            let expected = "import cycle: src/a.rs -> src/b.rs -> src/a.rs";
            assert_eq!(violations(&[a, ("src/b.rs", text)])?, [expected], "{text}");
        }
        let parent = ("src/a.rs", "mod c; pub struct A; fn f() { c::g() }");
        let child = ("src/a/c.rs", "use super::A;");
        let expected = "import cycle: src/a.rs -> src/a/c.rs -> src/a.rs";
        assert_eq!(violations(&[parent, child])?, [expected]);
        Ok(())
    }

    #[test]
    fn follows_re_exports_to_the_defining_file() -> anyhow::Result<()> {
        let files = [
            ("src/a.rs", "mod c; mod d; pub use c::*; pub use d::D;"),
            ("src/a/c.rs", "pub struct C;"),
            ("src/a/d.rs", "use super::C; pub struct D;"),
            ("src/b.rs", "use crate::{C, a::D}; fn f() { g(a::b::c) }"),
        ];
        assert_eq!(violations(&files)?, [""; 0]);
        Ok(())
    }
}
