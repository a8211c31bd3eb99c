use anyhow::Result;

use crate::command::{cargo, run};

/// Number of interruptions of each kind of output.
const RUNS: &str = "200";

/// Interrupts the simulator while it writes pictures and animations.
pub(super) fn check() -> Result<()> {
    let mut test = cargo();
    test.args(["test", "--package", "whitted-sim", "--test", "cli"]);
    run(test
        .args(["interrupts", "--", "--nocapture"])
        .env("RUNS", RUNS))
}
