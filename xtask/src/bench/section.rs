//! The sections of docs/benchmarks.md, each written by a task of its own.

use std::fs;

use anyhow::{Context, Result};

use crate::root;

/// Puts this text in the section's place.
pub(crate) fn replace(name: &str, text: &str) -> Result<()> {
    let file = root().join("docs/benchmarks.md");
    let document = fs::read_to_string(&file)?;
    let replaced = replaced(&document, name, text).with_context(|| {
        let [begin, end] = marks(name);
        format!("docs/benchmarks.md has no lines {begin} and {end}")
    })?;
    Ok(fs::write(file, replaced)?)
}

/// The lines around a section; as comments, they are not seen.
fn marks(name: &str) -> [String; 2] {
    [format!("<!-- {name} -->\n"), format!("<!-- /{name} -->\n")]
}

fn replaced(document: &str, name: &str, text: &str) -> Option<String> {
    let [begin, end] = marks(name);
    let (before, rest) = document.split_once(&begin)?;
    let (_, after) = rest.split_once(&end)?;
    Some(format!("{before}{begin}{text}{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_sections_stay_as_they_are() {
        let document = "<!-- a -->\nold\n<!-- /a -->\n\n<!-- b -->\nb\n<!-- /b -->\n";
        let expected = document.replace("old", "new");
        assert_eq!(replaced(document, "a", "new\n"), Some(expected));
    }

    #[test]
    fn a_section_that_is_not_there_is_no_place_to_write_to() {
        assert_eq!(replaced("<!-- a -->\nold\n", "a", "new\n"), None);
        assert_eq!(replaced("", "b", "new\n"), None);
    }

    #[test]
    fn the_document_has_the_sections() -> Result<()> {
        let document = fs::read_to_string(root().join("docs/benchmarks.md"))?;
        for name in ["frames", "growth"] {
            assert!(replaced(&document, name, "").is_some(), "{name}");
        }
        Ok(())
    }
}
