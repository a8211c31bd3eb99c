//! All checks and tests, in the order in which a person would want to know.

use anyhow::Result;

use crate::command::{self, cargo, command};
use crate::firmware::{V6M, V7M};
use crate::prove::panics;
use crate::steps::{self, Step};
use crate::{bench, board, pico, tidy, tools};

const STEPS: [Step; 14] = [
    ("tools", tools::install),
    ("ahead", board::build_ahead),
    ("format", format),
    ("tidy", tidy::run),
    ("clippy-host", clippy_host),
    ("clippy-thumb", clippy_thumb),
    ("docs", docs),
    ("test-host", test_host),
    ("test-window", test_window),
    ("nopanic", panics::link_all),
    ("test-qemu", test_qemu),
    ("budget", bench::check),
    ("boards", test_boards),
    ("pico", pico::check),
];

/// Runs the steps whose names contain one of the words, or all.
pub fn run(words: &[String]) -> Result<()> {
    steps::run(&STEPS, words)
}

fn format() -> Result<()> {
    command::run(cargo().args(["fmt", "--all", "--check"]))?;
    board::all().try_for_each(|board| {
        let mut fmt = cargo();
        command::run(fmt.current_dir(board.folder()).args(["fmt", "--check"]))
    })
}

/// All that runs on the host is built with windows, once for all steps.
pub(crate) const WINDOW: [&str; 2] = ["--features", "whitted-sim/window"];

/// What runs on the host, tests and examples included, and the simulator as it
/// is without windows.
fn clippy_host() -> Result<()> {
    for what in [
        &["--all-targets", WINDOW[0], WINDOW[1]][..],
        &["--bin", "sim"],
    ] {
        let mut clippy = cargo();
        clippy.args(["clippy", "--quiet"]).args(what);
        command::run(clippy.args(["--", "-D", "warnings"]))?;
    }
    Ok(())
}

/// The library where there is no standard library and the fewest instructions,
/// and the firmware.
fn clippy_thumb() -> Result<()> {
    let packages = [
        "float",
        "headless",
        "lm3s6965evb",
        "motion",
        "nopanic",
        "soak",
    ];
    for (target, packages) in [(V6M, &["whitted", "products"][..]), (V7M, &packages)] {
        let mut clippy = cargo();
        clippy.args(["clippy", "--quiet", "--target", target]);
        for package in packages {
            clippy.args(["--package", package]);
        }
        command::run(clippy.args(["--", "-D", "warnings"]))?;
    }
    Ok(())
}

fn docs() -> Result<()> {
    let mut doc = cargo();
    doc.args(["doc", "--quiet", "--no-deps"]).args(WINDOW);
    command::run(doc.env("RUSTDOCFLAGS", "-D warnings"))
}

/// Of the random scenes, a part; `prove` takes all.
fn test_host() -> Result<()> {
    let mut test = cargo();
    test.args(["test", "--quiet", "--no-fail-fast"])
        .args(WINDOW);
    command::run(test.env("SCENES", "300"))
}

/// On an X screen that nobody sees.
fn test_window() -> Result<()> {
    let mut xvfb = command("xvfb-run");
    xvfb.args(["--auto-servernum", "--server-args", "-screen 0 800x700x24"]);
    xvfb.arg(cargo().get_program());
    command::run(
        xvfb.args(["test", "--quiet", "--test", "window"])
            .args(WINDOW),
    )
}

/// What boards with displays show, in emulators; and that all fit into their flash.
fn test_boards() -> Result<()> {
    board::build_all()?;
    command::run(cargo().args(["test", "--quiet", "--package", "xtask", "--test", "boards"]))
}

fn test_qemu() -> Result<()> {
    command::run(cargo().args(["test", "--package", "xtask", "--test", "qemu"]))
}
