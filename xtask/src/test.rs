//! All checks and tests, in the order in which a person would want to know.

use std::time::{Duration, Instant};

use anyhow::{Result, bail};

use crate::command::{self, cargo};
use crate::firmware::{FLOAT, HEADLESS, LM3S6965EVB, PRODUCTS, V6M};
use crate::{bench, board, tidy, tools};

type Step = (&'static str, fn() -> Result<()>);

const STEPS: [Step; 10] = [
    ("tools", tools::install),
    ("format", format),
    ("tidy", tidy::run),
    ("clippy-host", clippy_host),
    ("clippy-thumb", clippy_thumb),
    ("docs", docs),
    ("test-host", test_host),
    ("test-qemu", test_qemu),
    ("test-boards", test_boards),
    ("budget", bench::check),
];

/// Runs the steps whose names contain one of the words, or all. A step that
/// fails does not keep the ones after it from running.
pub fn run(words: &[String]) -> Result<()> {
    let chosen = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word));
    let mut summary = Vec::new();
    for (name, step) in STEPS {
        if !chosen(name) {
            summary.push((name, "not run", Duration::ZERO));
            continue;
        }
        println!("==> {name}");
        let start = Instant::now();
        let outcome = match step() {
            Ok(()) => "ok",
            Err(error) => {
                eprintln!("error: {error:#}");
                "FAILED"
            }
        };
        let time = start.elapsed();
        println!("<== {name}: {outcome}, {:.1} s", time.as_secs_f32());
        summary.push((name, outcome, time));
        // Nothing works without the tools.
        if name == "tools" && outcome != "ok" {
            break;
        }
    }
    println!("\nsummary");
    for (name, outcome, time) in &summary {
        println!("  {name:12} {outcome:8} {:6.1} s", time.as_secs_f32());
    }
    if summary.iter().any(|(_, outcome, _)| *outcome == "FAILED") {
        bail!("not all steps passed");
    }
    if !summary.iter().any(|(_, outcome, _)| *outcome == "ok") {
        bail!("no step has such a name");
    }
    Ok(())
}

fn format() -> Result<()> {
    command::run(cargo().args(["fmt", "--all", "--check"]))?;
    board::all().try_for_each(|board| {
        let mut fmt = cargo();
        command::run(fmt.current_dir(board.folder()).args(["fmt", "--check"]))
    })
}

/// What runs on the host, tests and examples included.
fn clippy_host() -> Result<()> {
    command::run(cargo().args(["clippy", "--quiet", "--all-targets", "--", "-D", "warnings"]))
}

/// The library where there is no standard library and the fewest instructions,
/// and the firmware.
fn clippy_thumb() -> Result<()> {
    let firmware = [LM3S6965EVB, PRODUCTS]
        .into_iter()
        .chain(HEADLESS)
        .chain(FLOAT);
    let packages = firmware.map(|firmware| (firmware.package, firmware.target));
    for (package, target) in [("whitted", V6M)].into_iter().chain(packages) {
        let mut clippy = cargo();
        clippy.args([
            "clippy",
            "--quiet",
            "--package",
            package,
            "--target",
            target,
        ]);
        command::run(clippy.args(["--", "-D", "warnings"]))?;
    }
    Ok(())
}

fn docs() -> Result<()> {
    let mut doc = cargo();
    doc.args(["doc", "--quiet", "--no-deps"]);
    command::run(doc.env("RUSTDOCFLAGS", "-D warnings"))
}

fn test_host() -> Result<()> {
    command::run(cargo().args(["test", "--quiet", "--no-fail-fast"]))
}

/// What boards with displays show, in emulators.
fn test_boards() -> Result<()> {
    command::run(cargo().args(["test", "--quiet", "--package", "xtask", "--test", "boards"]))
}

fn test_qemu() -> Result<()> {
    command::run(cargo().args(["test", "--package", "xtask", "--test", "qemu"]))
}
