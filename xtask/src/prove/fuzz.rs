//! cargo-fuzz, each target for a while.

use std::fs;
use std::process::Stdio;

use anyhow::{Context, Result, ensure};

use super::tools::{self, NIGHTLY};
use crate::command::command;
use crate::{root, target_dir};

/// Seconds for each target, unless `FUZZ_SECONDS` says otherwise.
const SECONDS: &str = "300";

/// Runs of each target that are enough.
const RUNS: u64 = 10_000_000;

pub(super) fn prove() -> Result<String> {
    tools::toolchain(NIGHTLY, "toolchain install nightly")?;
    tools::subcommand("fuzz")?;
    let seconds = std::env::var("FUZZ_SECONDS").unwrap_or(SECONDS.to_owned());
    let mut targets = Vec::new();
    for entry in fs::read_dir(root().join("fuzz/corpus"))? {
        targets.push(entry?.file_name().to_string_lossy().into_owned());
    }
    targets.sort();
    let run = |target| fuzz(target, &seconds);
    let figures: Result<Vec<String>> = targets.iter().map(run).collect();
    Ok(figures?.join("; "))
}

/// Fuzzes a target, and says how often it ran.
fn fuzz(target: &String, seconds: &str) -> Result<String> {
    // New inputs go to the first, of which few are worth to be committed.
    let found = target_dir().join("fuzz-corpus").join(target);
    fs::create_dir_all(&found)?;
    let mut fuzz = command("cargo");
    fuzz.args([NIGHTLY, "fuzz", "run", "--sanitizer", "none", target]);
    fuzz.arg(found).arg(format!("fuzz/corpus/{target}"));
    fuzz.args(["--", &format!("-max_total_time={seconds}"), "-max_len=4096"]);
    fuzz.arg(format!("-runs={RUNS}"));
    fuzz.env("CARGO_TARGET_DIR", target_dir().join("fuzz"));
    fuzz.env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO");
    let output = fuzz.stdout(Stdio::inherit()).output()?;
    let log = String::from_utf8_lossy(&output.stderr);
    let tail = || log.lines().rev().take(20).collect::<Vec<_>>().join("\n");
    ensure!(
        output.status.success(),
        "{target}, last line first:\n{}",
        tail()
    );
    let done = log.lines().find(|line| line.starts_with("Done "));
    let done = done.with_context(|| format!("{target} tells nothing:\n{}", tail()))?;
    println!("{target}: {done}");
    // "Done 123 runs in 45 second(s)"
    Ok(format!("{target}: {}", done.trim_start_matches("Done ")))
}
