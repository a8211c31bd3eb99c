//! Checks the layers of the library.

use super::modules::{Crate, Dependency};

/// Lists the top-level modules of the library in layers, one layer in each row. A module may use
/// itself and the modules in earlier rows.
const LAYERS: [&[&str]; 10] = [
    &["math"],
    &["archive"],
    &["scene"],
    &["observer"],
    &["geometry"],
    &["prepare"],
    &["codec"],
    &["animation"],
    &["scene_buffer", "trace"],
    &["render"],
];

/// The crate for displays, and the layer that alone may use it.
const DISPLAY: (&str, &str) = ("embedded_graphics_core", "render");

/// Returns the violations. A module must not depend on another module in the same row or in a
/// later row. The page docs/architecture.md must have a table of the layers.
pub(super) fn check(library: &Crate, page: &str) -> Vec<String> {
    let mut violations = Vec::new();
    for (path, module) in &library.modules {
        // Skips the root of the library, because it only declares modules. Skips tests, because
        // they may use any module.
        let Some(layer) = path.first().filter(|layer| *layer != "tests") else {
            continue;
        };
        let mut add = |line, text: &str| violations.push(module.source.at(line, text));
        if row(layer).is_none() {
            add(1, "belongs to no layer; see xtask/src/tidy/layers.rs");
        }
        for Dependency { module, line } in library.dependencies(path) {
            // The root of the library only declares modules.
            let Some(used) = module.first() else {
                continue;
            };
            if used != layer && row(used).is_none_or(|used| Some(used) >= row(layer)) {
                add(line, &format!("uses the higher layer `{used}`"));
            }
        }
        let (display, allowed) = DISPLAY;
        let tokens = module.source.tokens.iter();
        for token in tokens.filter(|token| token.text == display && layer != allowed) {
            add(token.line, &format!("`{display}` belongs to `{allowed}`"));
        }
    }
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `"));
    let names = rows.filter_map(|row| Some(row.split_once('`')?.0));
    let expected = LAYERS.concat();
    if !names
        .filter(|name| row(name).is_some())
        .eq(expected.iter().copied())
    {
        let table = "docs/architecture.md: has no table of the layers";
        violations.push(format!("{table} {}", expected.join(", ")));
    }
    violations
}

fn row(layer: &str) -> Option<usize> {
    LAYERS.iter().position(|row| row.contains(&layer))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tidy::source::parse_all;

    #[test]
    fn accepts_only_lower_layers() -> anyhow::Result<()> {
        let row = |layer: &&str| format!("| `{layer}` |\n");
        let page: String = LAYERS.concat().iter().map(row).collect();
        for (path, text, count) in [
            ("src/trace.rs", "use crate::Scene; fn f() { scene::A }", 0),
            ("src/math.rs", "use crate::Scene;", 1),
            ("src/trace/tree.rs", "fn f() { crate::render::A }", 1),
            ("src/unknown.rs", "", 1),
            ("src/math.rs", "use embedded_graphics_core::Size;", 1),
            ("src/render/a.rs", "use embedded_graphics_core::Size;", 0),
        ] {
            let sources = parse_all(&[
                ("src/lib.rs", "mod scene; mod render; pub use scene::Scene;"),
                ("src/scene.rs", "pub struct Scene;"),
                ("src/render.rs", "pub struct A;"),
                (path, text),
            ])?;
            let library = Crate::new("src", &sources);
            let violations = check(&library, &page);
            assert_eq!(violations.len(), count, "{violations:?}");
            assert_eq!(check(&library, "").len(), count + 1);
        }
        Ok(())
    }
}
