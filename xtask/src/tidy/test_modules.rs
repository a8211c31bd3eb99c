use std::path::Path;

use super::source::Source;

/// Files of tests that are programs of their own.
const PROGRAMS: [&str; 2] = ["all", "everywhere"];

/// Returns a violation for each file of the folder `tests` that `tests/all.rs` does not declare as
/// a module. Cargo would not compile such a file, so its tests would never run.
pub(super) fn check(sources: &[Source]) -> Vec<String> {
    let all = sources
        .iter()
        .find(|source| source.path == Path::new("tests/all.rs"));
    let tokens = all.map_or(&[][..], |source| &source.tokens);
    let mut violations = Vec::new();
    for source in sources {
        let name = source.path.file_stem().unwrap_or_default().display();
        let is_declared = tokens
            .windows(2)
            .any(|pair| pair[0].text == "mod" && pair[1].text == name.to_string());
        let is_program = PROGRAMS.contains(&name.to_string().as_str());
        if source.path.parent() == Some(Path::new("tests")) && !is_declared && !is_program {
            let path = source.path.display();
            violations.push(format!("{path}:1: tests/all.rs has no line `mod {name};`"));
        }
    }
    violations
}
