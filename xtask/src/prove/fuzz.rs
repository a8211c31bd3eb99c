use std::fs;

use anyhow::Result;

use crate::command::{cargo_of, run};
use crate::tools::require;
use crate::{root, target_dir};

/// Seconds for each fuzz target, unless the environment variable `FUZZ_SECONDS` is set.
const SECONDS: &str = "300";

/// Number of runs after which cargo-fuzz stops a target before its time is up.
const RUNS: u64 = 10_000_000;

/// Runs each fuzz target in the folder `fuzz` with cargo-fuzz.
pub(super) fn check() -> Result<()> {
    require(
        &["cargo", "+nightly", "fuzz"],
        "rustup toolchain install nightly && cargo install cargo-fuzz",
    )?;
    let seconds = std::env::var("FUZZ_SECONDS").unwrap_or(SECONDS.to_owned());
    for entry in fs::read_dir(root().join("fuzz/corpus"))? {
        let target = entry?.file_name();
        // cargo-fuzz writes new inputs to the first corpus folder. It is not in the repository,
        // because few new inputs are worth committing.
        let found = target_dir().join("fuzz-corpus").join(&target);
        fs::create_dir_all(&found)?;
        let mut fuzz = cargo_of("+nightly", "fuzz");
        fuzz.args(["fuzz", "run", "--sanitizer", "none"])
            .arg(&target);
        fuzz.arg(found)
            .arg(root().join("fuzz/corpus").join(&target));
        fuzz.args(["--", "-max_len=4096"]);
        fuzz.arg(format!("-max_total_time={seconds}"));
        run(fuzz.arg(format!("-runs={RUNS}")))?;
    }
    Ok(())
}
