use std::path::Path;

use whitted_sim::{compare, png16};

use crate::outcome::Outcome;

/// Prints how like two pictures are.
pub(crate) fn compare(a: &Path, b: &Path) -> Outcome {
    let comparison = compare::compare(&png16::read(a)?, &png16::read(b)?)?;
    println!("{comparison}");
    Ok(())
}
