//! `cargo xtask test`: all checks and tests, fast ones first.

mod features;
mod lints;

use anyhow::Result;

use crate::command::{self, cargo, command};
use crate::steps::{self, Step};
use crate::{bench, board, panics, pico, tidy, tools};
use lints::WINDOW;

const STEPS: [Step; 16] = [
    ("tools", tools::install),
    ("start-builds", board::start_builds),
    ("format", format),
    ("tidy", tidy::run),
    ("clippy-host", lints::host),
    ("clippy-thumb", lints::thumb),
    ("features", features::check_all),
    ("docs", docs),
    ("test-host", test_host),
    ("test-window", test_window),
    ("nopanic", panics::link_all),
    ("choices", bench::check_choices),
    ("test-qemu", test_qemu),
    ("budget", bench::check),
    ("boards", test_boards),
    ("pico", pico::check),
];

/// Runs the steps whose names contain one of the words, or all steps if there are no words.
pub fn run(words: &[String]) -> Result<()> {
    steps::run(&STEPS, words)
}

fn format() -> Result<()> {
    command::run(cargo().args(["fmt", "--all", "--check"]))?;
    board::folders()
        .try_for_each(|folder| command::run(cargo().current_dir(folder).args(["fmt", "--check"])))
}

fn docs() -> Result<()> {
    let mut doc = cargo();
    doc.args(["doc", "--quiet", "--no-deps"]).args(WINDOW);
    command::run(doc.env("RUSTDOCFLAGS", "-D warnings"))
}

/// Runs the tests on the host. They draw 300 random scenes; `cargo xtask prove pictures` draws
/// 1000. Examples are not built as programs, because tests/examples.rs contains them.
fn test_host() -> Result<()> {
    ["--tests", "--doc"].into_iter().try_for_each(|kind| {
        let mut test = cargo();
        test.args(["test", "--quiet", "--no-fail-fast", kind])
            .args(WINDOW);
        command::run(test.env("SCENES", "300"))
    })
}

/// Tests the window of `sim view` on a virtual X screen.
fn test_window() -> Result<()> {
    let mut xvfb = command("xvfb-run");
    xvfb.args(["--auto-servernum", "--server-args", "-screen 0 800x700x24"]);
    xvfb.arg(cargo().get_program());
    xvfb.args(["test", "--quiet", "--test", "window"])
        .args(WINDOW);
    command::run(&mut xvfb)
}

/// Compares the flash of all boards with the budgets, and checks the pictures of the STM32F405 in
/// QEMU.
fn test_boards() -> Result<()> {
    board::build_all()?;
    command::run(cargo().args(["test", "--quiet", "--package", "xtask", "--test", "boards"]))
}

fn test_qemu() -> Result<()> {
    command::run(cargo().args(["test", "--package", "xtask", "--test", "qemu"]))
}
