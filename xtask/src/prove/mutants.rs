//! Whether the tests bite: cargo-mutants on a sample.

use std::fs;
use std::process::Command;

use anyhow::{Result, ensure};
use fastrand::Rng;

use super::tools;
use crate::command::cargo;
use crate::target_dir;

const FILES: [&str; 12] = [
    "src/num.rs",
    "src/num/*.rs",
    "src/vector.rs",
    "src/color.rs",
    "src/optics.rs",
    "src/shape/**/*.rs",
    "src/acceleration.rs",
    "src/coverage.rs",
    "src/intersect.rs",
    "src/shade.rs",
    "src/shadow.rs",
    "src/tracer.rs",
];

/// What catches most: it draws all scenes.
const FIRST: [&str; 1] = ["--test=golden"];

/// The tests that are fast, for what is then left.
const TESTS: [&str; 7] = [
    "--lib",
    "--test=antialias_contract",
    "--test=draw_target",
    "--test=fuzz",
    "--test=prepare",
    "--test=special_scenes",
    "--test=surfaces",
];

/// Mutants of the sample, unless `MUTANTS` says otherwise.
const SAMPLE: usize = 300;

/// The least share of those that build which the tests must catch, in percent.
const LEAST: usize = 85;

/// Seconds that the tests may take with a mutant; some never end.
const PATIENCE: u32 = 120;

pub(super) fn prove() -> Result<String> {
    tools::subcommand("mutants")?;
    let sample = std::env::var("MUTANTS")
        .ok()
        .and_then(|number| number.parse().ok());
    let all = list()?;
    let count = all.len();
    let sample = sample_of(all, sample.unwrap_or(SAMPLE));

    let first = run(&sample, &FIRST, "first")?;
    let mut missed = run(&first.missed, &TESTS, "rest")?.missed;
    // Some mutants have no name that they can be left out by.
    missed.retain(|mutant| first.missed.contains(mutant));
    let viable = first.caught + first.missed.len();
    ensure!(viable > 0, "no mutant was built");
    let caught = viable - missed.len();
    let share = 100 * caught / viable;
    println!("not caught:\n{}", missed.join("\n"));
    ensure!(share >= LEAST, "{share} % caught");
    Ok(format!(
        "{caught} of {viable} viable mutants caught, {share} %: a sample of {count}"
    ))
}

#[derive(Default)]
struct Outcome {
    caught: usize,
    missed: Vec<String>,
}

/// Lets these tests meet these mutants; what they tell is in a folder of this name.
fn run(mutants: &[String], tests: &[&str], name: &str) -> Result<Outcome> {
    if mutants.is_empty() {
        return Ok(Outcome::default());
    }
    let folder = target_dir().join("mutants").join(name);
    fs::create_dir_all(&folder)?;
    let mut command = cargo_mutants();
    command.arg(format!("--timeout={PATIENCE}"));
    // Of a run that is cut short, what is done is a sample, too.
    command.args(["--jobs=2", "--shuffle", "--output"]);
    command.arg(&folder);
    command.args(
        mutants
            .iter()
            .map(|mutant| format!("--re={}", exactly(mutant))),
    );
    command.args(tests.iter().map(|test| format!("--cargo-arg={test}")));
    // Each job builds in its own folder.
    command.env_remove("CARGO_TARGET_DIR");
    // Less to build, and to run, where no test asks for it.
    command
        .env("CARGO_PROFILE_DEV_DEBUG", "0")
        .env("RUNS", "200");
    let status = command.status()?;
    ensure!(
        is_tested(status.code()),
        "cargo mutants tested nothing: {status}"
    );

    let told = |list: &str| {
        let file = folder.join("mutants.out").join(list).with_extension("txt");
        let names = fs::read_to_string(file)?;
        Ok::<_, anyhow::Error>(names.lines().map(str::to_owned).collect::<Vec<_>>())
    };
    Ok(Outcome {
        caught: told("caught")?.len() + told("timeout")?.len(),
        missed: told("missed")?,
    })
}

/// Whether mutants met the tests: where all are caught, some are missed (2) or never end
/// (3), but not where the tests fail without a mutant, or do not build.
fn is_tested(code: Option<i32>) -> bool {
    matches!(code, Some(0 | 2 | 3))
}

fn cargo_mutants() -> Command {
    let mut mutants = cargo();
    mutants.args(["mutants", "--package", "whitted"]);
    mutants.args(FILES.map(|file| format!("--file={file}")));
    mutants
}

/// The names of all mutants there are.
fn list() -> Result<Vec<String>> {
    let output = cargo_mutants().arg("--list").output()?;
    let names: Vec<_> = String::from_utf8(output.stdout)?
        .lines()
        .map(str::to_owned)
        .collect();
    ensure!(!names.is_empty(), "cargo mutants lists none");
    Ok(names)
}

/// So many of them at random, but the same in each run.
fn sample_of(mut mutants: Vec<String>, count: usize) -> Vec<String> {
    Rng::with_seed(0).shuffle(&mut mutants);
    mutants.truncate(count);
    mutants
}

/// A regular expression of this text alone.
fn exactly(text: &str) -> String {
    let mut expression = String::from("^");
    for letter in text.chars() {
        if r"\.+*?()|[]{}^$".contains(letter) {
            expression.push('\\');
        }
        expression.push(letter);
    }
    expression + "$"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sample_is_the_same_each_time() {
        let all: Vec<_> = (0..100).map(|number| number.to_string()).collect();
        let sample = sample_of(all.clone(), 10);
        assert_eq!(sample, sample_of(all.clone(), 10));
        assert_ne!(sample, all[..10]);
    }

    #[test]
    fn punctuation_stands_for_itself() {
        assert_eq!(exactly("a.rs: (+)"), r"^a\.rs: \(\+\)$");
    }
}
