//! Whether the tests bite: cargo-mutants on a sample.

use std::fs;

use anyhow::{Result, ensure};

use super::tools;
use crate::command::cargo;
use crate::target_dir;

const FILES: [&str; 10] = [
    "src/num.rs",
    "src/num/*.rs",
    "src/vector.rs",
    "src/color.rs",
    "src/optics.rs",
    "src/shape/**/*.rs",
    "src/intersect.rs",
    "src/shade.rs",
    "src/shadow.rs",
    "src/tracer.rs",
];

/// The tests that are fast.
const TESTS: [&str; 8] = [
    "--lib",
    "--test=compiled",
    "--test=coverage",
    "--test=draw_target",
    "--test=fuzz",
    "--test=golden",
    "--test=special_scenes",
    "--test=surfaces",
];

/// Mutants of the sample, unless `MUTANTS` says otherwise.
const SAMPLE: usize = 300;

/// The least share of those that build which the tests must catch, in percent.
const LEAST: usize = 85;

pub(super) fn prove() -> Result<String> {
    tools::subcommand("mutants")?;
    let sample = std::env::var("MUTANTS")
        .ok()
        .and_then(|number| number.parse().ok());
    let sample = sample.unwrap_or(SAMPLE);
    let mut list = cargo();
    list.args(["mutants", "--list", "--package", "whitted"]);
    list.args(FILES.map(|file| format!("--file={file}")));
    let all = String::from_utf8(list.output()?.stdout)?.lines().count();
    ensure!(all > 0, "cargo mutants lists none");

    let out = target_dir().join("mutants");
    fs::create_dir_all(&out)?;
    let mut mutants = cargo();
    mutants.args(["mutants", "--package", "whitted", "--timeout=300"]);
    // Every so manieth, in the order of the files: the same in each run.
    mutants.arg(format!("--shard=0/{}", all.div_ceil(sample)));
    mutants
        .arg("--sharding=round-robin")
        .arg("--output")
        .arg(&out);
    mutants.args(FILES.map(|file| format!("--file={file}")));
    mutants.arg("--").args(TESTS);
    // It fails where a mutant survives.
    _ = mutants.status()?;

    let count = |name: &str| {
        let file = out.join("mutants.out").join(name).with_extension("txt");
        Ok::<_, anyhow::Error>(fs::read_to_string(file)?.lines().count())
    };
    let (caught, missed) = (count("caught")? + count("timeout")?, count("missed")?);
    ensure!(caught + missed > 0, "no mutant was built");
    let share = 100 * caught / (caught + missed);
    ensure!(
        share >= LEAST,
        "{share} % caught; the survivors are in {}",
        out.join("mutants.out/missed.txt").display()
    );
    Ok(format!(
        "{caught} of {} viable mutants caught, {share} %, of {all} in all",
        caught + missed
    ))
}
