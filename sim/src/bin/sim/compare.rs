use std::io::Write;
use std::path::Path;

use whitted_sim::compare;

use crate::console::Console;
use crate::outcome::Outcome;

/// Prints the difference between two PNGs.
pub(crate) fn compare(a: &Path, b: &Path) -> Outcome {
    let comparison = compare::compare_files(a, b)?;
    Ok(writeln!(Console::Stdout, "{comparison}")?)
}
