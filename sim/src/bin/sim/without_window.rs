use std::env;
use std::process::{Command, exit};

use crate::args::View;
use crate::outcome::Outcome;

const HOW: &str = "this build cannot open windows
  help: install SDL 2 (Debian: apt install libsdl2-dev; macOS: brew install sdl2), then
        cargo run --release --package whitted-sim --features window -- view";

/// Has Cargo build and run the program with windows, if it was Cargo that ran
/// this one; else says how to.
pub(crate) fn view(_options: &View) -> Outcome {
    let Some(cargo) = env::var_os("CARGO") else {
        return Err(HOW.into());
    };
    let mut cargo = Command::new(cargo);
    cargo.args(["run", "--quiet", "--release", "--features", "window"]);
    cargo.args([
        "--manifest-path",
        concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml"),
    ]);
    let status = cargo.arg("--").args(env::args_os().skip(1)).status()?;
    match status.code() {
        // What Cargo ends with where the build fails.
        Some(101) => Err(HOW.into()),
        code => exit(code.unwrap_or(1)),
    }
}
