//! All checks and tests, in the order in which a person would want to know.

use anyhow::Result;

use crate::command::{self, cargo};
use crate::firmware::{FLOAT, HEADLESS, LM3S6965EVB, PRODUCTS, V6M, V7M, nopanic};
use crate::prove::panics;
use crate::steps::{self, Step};
use crate::{bench, tidy, tools};

const STEPS: [Step; 10] = [
    ("tools", tools::install),
    ("format", format),
    ("tidy", tidy::run),
    ("clippy-host", clippy_host),
    ("clippy-thumb", clippy_thumb),
    ("docs", docs),
    ("test-host", test_host),
    ("nopanic", panics::link_all),
    ("test-qemu", test_qemu),
    ("budget", bench::check),
];

/// Runs the steps whose names contain one of the words, or all.
pub fn run(words: &[String]) -> Result<()> {
    steps::run(&STEPS, words)
}

fn format() -> Result<()> {
    command::run(cargo().args(["fmt", "--all", "--check"]))
}

/// What runs on the host, tests and examples included.
fn clippy_host() -> Result<()> {
    command::run(cargo().args(["clippy", "--quiet", "--all-targets", "--", "-D", "warnings"]))
}

/// The library where there is no standard library and the fewest instructions,
/// and the firmware.
fn clippy_thumb() -> Result<()> {
    let firmware = [LM3S6965EVB, PRODUCTS, nopanic(V7M)]
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

fn test_qemu() -> Result<()> {
    command::run(cargo().args(["test", "--package", "xtask", "--test", "qemu"]))
}
