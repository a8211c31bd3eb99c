use std::fs;

use anyhow::Result;

use crate::command::{cargo_of, run};
use crate::tools::require;
use crate::{root, target_dir};

/// Number of seconds to run each fuzz target. The environment variable `FUZZ_SECONDS` overrides it.
const SECONDS: &str = "300";

/// Largest number of runs of a fuzz target. cargo-fuzz stops after this number, even if time is
/// left.
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
        // cargo-fuzz writes new inputs to the first of two corpus folders. The first folder is in
        // the target folder, because few new inputs are worth committing.
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
