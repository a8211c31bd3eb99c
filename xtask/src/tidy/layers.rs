//! Which module may use which: the library's modules are layers, and the graph
//! of its files has no cycle.

mod imports;

use std::collections::{BTreeMap, BTreeSet};

use super::tokens::Source;
use super::{Complaint, module_of};
use imports::{Import, Path, imports};

/// The layers, each of which may use those above it in this list only.
#[rustfmt::skip]
const LAYERS: &[&str] = &[
    // Numbers.
    "num", "vector", "angle", "color", "checksum", "optics",
    // What a person writes down.
    "error", "scene", "animation",
    // What is traced, scaled.
    "observer", "ray", "texture", "shape", "prepared", "acceleration", "camera",
    // From the one to the other.
    "prepare", "compiled", "buffer",
    // Nearest hit, local light, the tree of rays.
    "intersect", "coverage", "shadow", "shade", "tracer", "raster",
    // Colors to pixels, lines to displays.
    "output", "pixel", "drawing", "renderer", "changes", "antialias",
];

/// Complains about uses of a higher layer, layers that are not in the list,
/// and cycles.
pub(super) fn check(library: &[Source]) -> Vec<Complaint> {
    check_against(LAYERS, library)
}

fn check_against(layers: &[&str], library: &[Source]) -> Vec<Complaint> {
    let modules = Modules::new(library);
    let place = |module: &Path| {
        layers
            .iter()
            .position(|layer| Some(*layer) == module.first().map(String::as_str))
    };
    let mut complaints = Vec::new();
    let mut graph = Graph::new();
    for source in library {
        let module = module_of(&source.path);
        // The root only names the layers, and what of them is public; a file of
        // tests alone may use what it tests.
        if module.is_empty() || source.tokens.is_empty() {
            continue;
        }
        let Some(layer) = place(&module) else {
            complaints.push(source.complain(0, "is in no layer: name it in the list of layers"));
            continue;
        };
        for import in modules.uses(&module) {
            let used = modules.resolve(&import.path);
            if place(&used).is_none_or(|used| used > layer) {
                let what = format!(
                    "uses {}, which is in a higher layer",
                    import.path.join("::")
                );
                complaints.push(source.complain(import.token, &what));
            }
            if used != module {
                graph.entry(module.clone()).or_default().insert(used);
            }
        }
    }
    complaints.extend(cycle(&graph));
    complaints
}

/// Each module, and the modules that it uses.
type Graph = BTreeMap<Path, BTreeSet<Path>>;

/// A cycle, if there is one.
fn cycle(graph: &Graph) -> Option<Complaint> {
    let mut left = graph.clone();
    // What uses nothing that is left is in no cycle.
    loop {
        let (users, free): (Graph, Graph) = left
            .iter()
            .map(|(module, used)| (module.clone(), used.clone()))
            .partition(|(_, used)| used.iter().any(|used| left.contains_key(used)));
        if free.is_empty() {
            break;
        }
        left = users;
    }
    // From here on every step leads on, and at last round in a circle.
    let mut module = left.keys().next()?;
    let mut walk = Vec::new();
    while !walk.contains(&module) {
        walk.push(module);
        module = left[module].iter().find(|used| left.contains_key(*used))?;
    }
    let circle = walk
        .iter()
        .skip_while(|passed| **passed != module)
        .chain([&module]);
    let names: Vec<String> = circle.map(|module| module.join("::")).collect();
    Some(format!(
        "src: modules use each other in a circle: {}",
        names.join(" -> ")
    ))
}

/// The modules by their paths, with what they import.
struct Modules(BTreeMap<Path, Vec<Import>>);

impl Modules {
    fn new(library: &[Source]) -> Self {
        let paths: BTreeSet<Path> = library
            .iter()
            .map(|source| module_of(&source.path))
            .collect();
        let of = |source: &Source| (module_of(&source.path), imports(source, &paths));
        Self(library.iter().map(of).collect())
    }

    /// What a module uses, without what it only passes on.
    fn uses(&self, module: &Path) -> impl Iterator<Item = &Import> {
        let imports = self.0.get(module).into_iter().flatten();
        imports.filter(|import| import.is_used || !import.is_public)
    }

    /// The module that defines what this path names.
    fn resolve(&self, path: &[String]) -> Path {
        let mut module = Path::new();
        for (index, name) in path.iter().enumerate() {
            let mut inner = module.clone();
            inner.push(name.clone());
            if self.0.contains_key(&inner) {
                module = inner;
                continue;
            }
            let passed_on = self.0.get(&module).into_iter().flatten();
            let Some(import) = passed_on
                .into_iter()
                .find(|import| import.is_public && import.name == *name)
            else {
                break;
            };
            return self.resolve(&[&import.path, &path[index + 1..]].concat());
        }
        module
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LAYERS: &[&str] = &["color", "scene", "tracer"];

    fn complaints(files: &[(&str, &str)]) -> Vec<Complaint> {
        let root = (
            "src/lib.rs",
            "mod color; pub use color::Color; mod scene; pub use scene::{Light, Scene}; mod tracer;",
        );
        let files = [root].into_iter().chain(files.iter().copied());
        let parse = |(path, text)| Source::parse(std::path::Path::new(path), text);
        let library: Result<Vec<Source>, _> = files.map(parse).collect();
        library.map_or_else(
            |error| vec![error.to_string()],
            |library| check_against(LAYERS, &library),
        )
    }

    #[test]
    fn down_the_layers_is_fine() {
        let files = [
            ("src/color.rs", "pub struct Color;"),
            (
                "src/scene.rs",
                "mod light; pub use light::Light; use crate::Color; pub struct Scene(Color);",
            ),
            (
                "src/scene/light.rs",
                "use crate::{Color, Scene}; pub struct Light(Color, Scene);",
            ),
            (
                "src/tracer.rs",
                "use crate::{color, scene::Scene}; fn f() -> crate::Light {}",
            ),
        ];
        assert_eq!(complaints(&files), [""; 0]);
    }

    #[test]
    fn up_the_layers_is_caught() {
        for text in [
            "use crate::Scene;",
            "use crate::scene::Scene as S;",
            "use crate::{tracer::{self}};",
            "fn f() -> crate::tracer::T {}",
            "use super::tracer;",
        ] {
            let files = [
                ("src/color.rs", text),
                ("src/scene.rs", "pub struct Scene;"),
                ("src/tracer.rs", ""),
            ];
            let complaints = complaints(&files);
            assert!(
                complaints.len() == 1 && complaints[0].contains("higher layer"),
                "{text}: {complaints:?}"
            );
        }
    }

    #[test]
    fn what_is_in_no_layer_is_caught() {
        assert!(complaints(&[("src/noise.rs", "fn f() {}")])[0].contains("no layer"));
        let uses_the_root = ("src/color.rs", "use crate::Unknown;");
        assert_eq!(complaints(&[uses_the_root]).len(), 1);
    }

    #[test]
    fn circles_are_caught() {
        let files = [
            (
                "src/scene.rs",
                "mod light; pub use light::Light; pub struct Scene(Light);",
            ),
            (
                "src/scene/light.rs",
                "use crate::Scene; pub struct Light(Scene);",
            ),
        ];
        let complaints = complaints(&files);
        assert_eq!(
            complaints,
            ["src: modules use each other in a circle: scene -> scene::light -> scene"]
        );
    }
}
