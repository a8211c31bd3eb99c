//! The instructions that a frame may take, as they are committed.

use std::collections::BTreeMap;
use std::fs;
use std::path::PathBuf;

use anyhow::{Context, Result, bail};
use serde::{Deserialize, Serialize};

use super::count::count;
use super::subject::IN_BUDGET;
use super::toolchain;
use crate::qemu::{Arithmetic, Core};
use crate::root;

/// Enough to tell one change from another: one core of each kind of code.
const CORES: [Core; 3] = [Core::M0, Core::M3, Core::M4f];

/// How far a count may be from the budget, in percent.
const TOLERANCE: u64 = 1;

/// Instructions by picture and core, `four_spheres 320x240 m3`.
type Counts = BTreeMap<String, u64>;

#[derive(Deserialize, Serialize)]
struct Budget {
    /// The compiler that they were counted with.
    toolchain: String,
    instructions: Counts,
}

/// Fails if a picture takes more than its budget.
pub fn check() -> Result<()> {
    let text = fs::read_to_string(file()).context("no budget; `cargo xtask bench --bless`")?;
    let budget: Budget = serde_json::from_str(&text)?;
    let toolchain = toolchain()?;
    if toolchain != budget.toolchain {
        println!("the budget is of {}, this is {toolchain}", budget.toolchain);
    }
    let Verdict {
        table,
        is_over,
        is_under,
    } = judge(&budget.instructions, &counted()?);
    print!("{table}");
    if is_over {
        bail!("over budget; if that is worth it, `cargo xtask bench --bless`, and say why");
    }
    if is_under {
        println!("under budget; to keep what was won, `cargo xtask bench --bless`");
    }
    Ok(())
}

/// Makes what is counted now the budget.
pub fn bless() -> Result<()> {
    let budget = Budget {
        toolchain: toolchain()?,
        instructions: counted()?,
    };
    fs::write(file(), serde_json::to_string_pretty(&budget)? + "\n")?;
    println!("wrote {}", file().display());
    Ok(())
}

fn file() -> PathBuf {
    root().join("xtask/budget.json")
}

fn counted() -> Result<Counts> {
    let rows = count(&IN_BUDGET, &CORES, &[Arithmetic::Fixed])?;
    let name = |row: &super::Row| format!("{} {} {}", row.scene, row.size, row.core);
    Ok(rows
        .iter()
        .map(|row| (name(row), row.instructions))
        .collect())
}

/// How counts stand to the budget.
struct Verdict {
    table: String,
    is_over: bool,
    is_under: bool,
}

/// What has no budget is over it.
fn judge(budget: &Counts, counted: &Counts) -> Verdict {
    let mut verdict = Verdict {
        table: String::new(),
        is_over: false,
        is_under: false,
    };
    for (name, now) in counted {
        let allowed = budget.get(name).copied().unwrap_or(0);
        let percent = 100.0 * (*now as f64 / allowed as f64 - 1.0);
        let is_over = now * 100 > allowed * (100 + TOLERANCE);
        let is_under = now * 100 < allowed * (100 - TOLERANCE);
        let mark = match (is_over, is_under) {
            (true, _) => "OVER",
            (_, true) => "under",
            _ => "",
        };
        verdict.table += &format!("{name:28} {allowed:12} {now:12} {percent:+7.2} % {mark}\n");
        verdict.is_over |= is_over;
        verdict.is_under |= is_under;
    }
    verdict
}

#[cfg(test)]
mod tests {
    use super::*;

    fn verdict(now: u64) -> (bool, bool) {
        let counts = |count| Counts::from([("a scene".to_owned(), count)]);
        let verdict = judge(&counts(1000), &counts(now));
        (verdict.is_over, verdict.is_under)
    }

    #[test]
    fn more_than_a_percent_is_over_or_under() {
        assert_eq!(verdict(1000), (false, false));
        assert_eq!(verdict(1010), (false, false));
        assert_eq!(verdict(1011), (true, false));
        assert_eq!(verdict(990), (false, false));
        assert_eq!(verdict(989), (false, true));
    }

    #[test]
    fn what_has_no_budget_is_over_it() {
        let counted = Counts::from([("a new scene".to_owned(), 1)]);
        assert!(judge(&Counts::new(), &counted).is_over);
    }
}
