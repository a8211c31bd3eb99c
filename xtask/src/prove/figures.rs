use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use anyhow::{Context, Result, ensure};

use crate::command::cargo;

/// Runs the library's tests of this name, or those that the flag names, and
/// returns what they tell in lines of `figure: ...`.
pub(super) fn figures(tests: &str, variables: &[(&str, &str)]) -> Result<String> {
    let mut test = cargo();
    test.args(["test", "--package", "whitted"]);
    match tests.starts_with("--") {
        true => test.arg(tests),
        false => test.args(["--test", tests]),
    };
    test.args(["--", "--nocapture"])
        .envs(variables.iter().copied());
    told(&mut test)
}

/// Runs a command to a good end, showing what it prints, and returns its figures.
pub(super) fn told(command: &mut Command) -> Result<String> {
    let mut child = command
        .stdout(Stdio::piped())
        .spawn()
        .with_context(|| format!("{command:?} does not start"))?;
    let output = child.stdout.take().context("it has an output")?;
    let mut figures = Vec::new();
    for line in BufReader::new(output).lines() {
        let line = line?;
        // Tests print their names without ending the line.
        match line.split_once("figure: ") {
            Some((_, figure)) => figures.push(figure.to_owned()),
            None => println!("{line}"),
        }
    }
    let status = child.wait()?;
    ensure!(status.success(), "{command:?} failed: {status}");
    ensure!(!figures.is_empty(), "{command:?} told no figures");
    figures.sort();
    Ok(figures.join("; "))
}
