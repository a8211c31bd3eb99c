use std::env;
use std::process::{Command, exit};

use crate::args::View;
use crate::outcome::Outcome;

const HELP: &str = "this build cannot open windows
  help: install SDL 2 (Debian: apt install libsdl2-dev; macOS: brew install sdl2), then
        cargo run --release --package whitted-sim --features window -- view";

/// Implements `sim view` if the program was built without the feature `window`. If Cargo started
/// the program, runs Cargo again with the feature. Otherwise, returns an error that shows the
/// command to run.
pub(crate) fn view(_options: &View) -> Outcome {
    let Some(cargo) = env::var_os("CARGO") else {
        return Err(HELP.into());
    };
    let mut cargo = Command::new(cargo);
    cargo.args(["run", "--quiet", "--release", "--features", "window"]);
    cargo.args([
        "--manifest-path",
        concat!(env!("CARGO_MANIFEST_DIR"), "/Cargo.toml"),
    ]);
    let status = cargo.arg("--").args(env::args_os().skip(1)).status()?;
    match status.code() {
        // Cargo exits with code 101 if the build fails.
        Some(101) => Err(HELP.into()),
        code => exit(code.unwrap_or(1)),
    }
}
