//! What no file of the project may say.

use std::path::Path;

use super::Complaint;

/// Places of somebody's machine. In two parts, so that this file passes.
const PLACES: [&str; 5] = [
    concat!("/ho", "me/"),
    concat!("/ro", "ot/"),
    concat!("/Us", "ers/"),
    concat!("/wo", "rk/"),
    concat!("../sha", "red"),
];

/// Complains about each line that names a place outside of the project.
pub(super) fn check(path: &Path, text: &str) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    for (number, line) in text.lines().enumerate() {
        if let Some(place) = PLACES.iter().find(|place| line.contains(*place)) {
            complaints.push(format!(
                "{}:{}: names {place}, which is on one machine only",
                path.display(),
                number + 1
            ));
        }
    }
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_caught() {
        let text = format!("fine\nsee {}me/notes\n", PLACES[0]);
        let complaints = check(Path::new("README.md"), &text);
        assert_eq!(complaints.len(), 1);
        assert!(complaints[0].starts_with("README.md:2: "));
    }
}
