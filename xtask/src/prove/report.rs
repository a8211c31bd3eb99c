//! docs/trust.md: its table of promises is written here, a row at a time.

use std::fs;

use anyhow::{Context, Result};

use super::PROMISES;
use crate::root;

const FILE: &str = "docs/trust.md";

/// Puts these figures in the promise's row.
pub(super) fn write(name: &str, figures: &str) -> Result<()> {
    let file = root().join(FILE);
    let document = fs::read_to_string(&file)?;
    let written = with(&document, name, figures).with_context(|| format!("{FILE} has no table"))?;
    Ok(fs::write(file, written)?)
}

/// The lines around the table; as comments, they are not seen.
const MARKS: [&str; 2] = ["<!-- promises -->\n", "<!-- /promises -->\n"];

fn with(document: &str, name: &str, figures: &str) -> Option<String> {
    let [begin, end] = MARKS;
    let (before, rest) = document.split_once(begin)?;
    let (table, after) = rest.split_once(end)?;
    let rows: String = PROMISES
        .iter()
        .map(|promise| {
            let told = match promise.name == name {
                true => figures.replace('|', "/"),
                false => told_before(table, promise.name)
                    .unwrap_or("not run yet")
                    .to_owned(),
            };
            let how = promise.how;
            format!(
                "| `{}` | {} | {how} | {told} |\n",
                promise.name, promise.says
            )
        })
        .collect();
    let head = "| `prove` | promise | how it is tested | figures |\n|---|---|---|---|\n";
    Some(format!("{before}{begin}{head}{rows}{end}{after}"))
}

/// The figures in the row of this name.
fn told_before<'t>(table: &'t str, name: &str) -> Option<&'t str> {
    let start = format!("| `{name}` |");
    let row = table.lines().find(|line| line.starts_with(&start))?;
    row.trim_end_matches('|').rsplit('|').next().map(str::trim)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_replaced_and_the_others_stay() {
        let [begin, end] = MARKS;
        let document = format!("a\n{begin}{end}b\n");
        let once = with(&document, "panics", "one").unwrap_or_default();
        let twice = with(&once, "fuzz", "two | three").unwrap_or_default();
        assert_eq!(told_before(&twice, "panics"), Some("one"));
        assert_eq!(told_before(&twice, "fuzz"), Some("two / three"));
        assert_eq!(told_before(&twice, "supply"), Some("not run yet"));
        assert!(twice.starts_with("a\n") && twice.ends_with("b\n"));
    }

    #[test]
    fn the_document_has_the_table() -> Result<()> {
        let document = fs::read_to_string(root().join(FILE))?;
        assert!(with(&document, "panics", "").is_some());
        Ok(())
    }
}
