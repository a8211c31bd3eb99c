use std::path::Path;

use whitted_sim::{compare, png16};

use crate::outcome::Outcome;

/// Prints the difference between two PNGs.
pub(crate) fn compare(a: &Path, b: &Path) -> Outcome {
    let comparison = compare::compare(&png16::read(a)?, &png16::read(b)?)?;
    println!("{comparison}");
    Ok(())
}
