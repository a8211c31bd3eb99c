use std::path::Path;

/// Beginnings of paths that exist only on one machine. Each text is split in two parts, because
/// this file must pass the check too.
const PLACES: [&str; 5] = [
    concat!("/ho", "me/"),
    concat!("/ro", "ot/"),
    concat!("/Us", "ers/"),
    concat!("/wo", "rk/"),
    concat!("../sha", "red"),
];

/// Returns a violation for each line with a path that exists only on one machine.
pub(super) fn check(path: &Path, text: &str) -> Vec<String> {
    let mut violations = Vec::new();
    for (line, number) in text.lines().zip(1..) {
        if let Some(place) = PLACES.iter().find(|place| line.contains(*place)) {
            let path = path.display();
            violations.push(format!(
                "{path}:{number}: {place} exists on one machine only"
            ));
        }
    }
    violations
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_paths_of_single_machines() {
        let text = format!("fine\nsee {}me/notes\n", PLACES[0]);
        let violations = check(Path::new("README.md"), &text);
        assert_eq!(violations.len(), 1);
        assert!(violations[0].starts_with("README.md:2: "));
    }
}
