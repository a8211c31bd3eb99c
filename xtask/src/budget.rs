//! Compares measurements with budgets, which are upper limits stored in the repository.

use std::collections::BTreeMap;
use std::fs;

use anyhow::{Context, Result, bail};

use crate::root;

/// Percentage by which a measurement may differ from its budget.
const TOLERANCE: u64 = 1;

/// Counts by the names of measurements, such as "whitted 160x120 m3".
pub(crate) type Counts = BTreeMap<String, u64>;

/// A budget: a JSON file of [`Counts`].
pub(crate) struct Budget {
    /// Path of the JSON file, relative to the root of the project.
    pub(crate) file: &'static str,
    /// Command that the user runs to write the JSON file.
    pub(crate) bless: &'static str,
}

impl Budget {
    /// Prints each count next to its budget. Returns an error if a count is over its budget by more
    /// than the tolerance.
    pub(crate) fn check(&self, counted: &Counts) -> Result<()> {
        let Self { file, bless } = self;
        let text = fs::read_to_string(root().join(file))
            .with_context(|| format!("no budget in {file}; run `{bless}`"))?;
        let budget: Counts = serde_json::from_str(&text)?;
        let mut verdicts = Vec::new();
        for (name, count) in counted {
            let allowed = budget.get(name).copied().unwrap_or(0);
            let verdict = judge(allowed, *count);
            let percent = 100.0 * (*count as f64 / allowed as f64 - 1.0);
            println!("{name:28} {allowed:12} {count:12} {percent:+7.2} % {verdict}");
            verdicts.push(verdict);
        }
        if verdicts.contains(&OVER) {
            bail!("over the budget in {file}; if the change is worth it, run `{bless}` and commit");
        }
        if verdicts.contains(&UNDER) {
            println!("under the budget; run `{bless}` to keep the gain");
        }
        Ok(())
    }

    /// Stores counts as the new budget.
    pub(crate) fn bless(&self, counted: &Counts) -> Result<()> {
        let file = root().join(self.file);
        fs::write(&file, serde_json::to_string_pretty(counted)? + "\n")?;
        println!("wrote {}", file.display());
        Ok(())
    }
}

const OVER: &str = "OVER";
const UNDER: &str = "under";

fn judge(allowed: u64, count: u64) -> &'static str {
    if count * 100 > allowed * (100 + TOLERANCE) {
        OVER
    } else if count * 100 < allowed * (100 - TOLERANCE) {
        UNDER
    } else {
        ""
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerates_one_percent() {
        let verdicts = [989, 990, 1000, 1010, 1011].map(|count| judge(1000, count));
        assert_eq!(verdicts, [UNDER, "", "", "", OVER]);
        assert_eq!(judge(0, 1), OVER);
    }
}
