//! The cycles that pictures may take, as they are committed.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, bail};

use crate::root;

/// How far cycles may be from the budget, in percent.
const TOLERANCE: u64 = 1;

/// The pictures that have one.
pub(super) const PICTURES: [&str; 3] = ["four_spheres", "from the right", "still_life"];

/// Cycles by picture.
type Cycles = BTreeMap<String, u64>;

/// Fails if a picture takes more than its budget.
pub(super) fn check(drawn: &[(&str, u64)]) -> Result<()> {
    let text = fs::read_to_string(file()).context("no budget; `cargo xtask pico --bless`")?;
    let budget: Cycles = serde_json::from_str(&text)?;
    match over(&budget, drawn) {
        Some(name) => bail!(
            "{name} is over budget; if that is worth it, `cargo xtask pico --bless`, and say why"
        ),
        None => Ok(()),
    }
}

/// Makes these cycles the budget.
pub(super) fn bless(drawn: &[(&str, u64)]) -> Result<()> {
    let budget: Cycles = drawn
        .iter()
        .map(|(name, cycles)| ((*name).to_owned(), *cycles))
        .collect();
    fs::write(file(), serde_json::to_string_pretty(&budget)? + "\n")?;
    println!("wrote {}", file().display());
    Ok(())
}

fn file() -> PathBuf {
    root().join("boards/pico/budget.json")
}

/// The first picture that takes more than its budget, or has none.
fn over<'d>(budget: &Cycles, drawn: &[(&'d str, u64)]) -> Option<&'d str> {
    let is_over = |(name, cycles): &&(&str, u64)| {
        let most = budget
            .get(*name)
            .map(|cycles| cycles + cycles * TOLERANCE / 100);
        most.is_none_or(|most| *cycles > most)
    };
    drawn.iter().find(is_over).map(|(name, _)| *name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_than_one_percent_is_over() {
        let budget = Cycles::from([("a".to_owned(), 1000), ("b".to_owned(), 500)]);
        assert_eq!(over(&budget, &[("a", 1010), ("b", 1)]), None);
        assert_eq!(over(&budget, &[("a", 1011), ("b", 1)]), Some("a"));
        assert_eq!(over(&budget, &[("a", 1000), ("c", 1)]), Some("c"));
    }
}
