//! The simulator for the host. It renders, animates, checks and compiles scenes, and sends scenes
//! to boards. It also compares pictures and prints ray trees.
//!
//! ```text
//! args ── open (scene) ── draw or linear ──> display ──> output (PNG), terminal, window
//! ```
#![warn(clippy::print_stderr, clippy::print_stdout)]

mod animate;
mod args;
mod boards;
mod compare;
mod console;
mod display;
mod draw;
mod estimate;
mod explain;
mod format;
mod gallery;
mod linear;
mod memory;
mod new;
mod number;
mod open;
mod outcome;
mod output;
mod panel;
mod progress;
mod render;
mod report;
mod scene;
mod send;
mod terminal;
#[cfg(feature = "window")]
mod view;
#[cfg(not(feature = "window"))]
#[path = "without_window.rs"]
mod view;

use std::io::Write;
use std::process::ExitCode;

use args::{Args, Command};
use console::Console;
use outcome::Outcome;
use output::ClosedPipe;

fn main() -> ExitCode {
    match run(Args::from_command_line()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) if error.is::<ClosedPipe>() => ExitCode::SUCCESS,
        Err(error) => {
            // No error of stderr can be reported.
            _ = writeln!(Console::Stderr, "error: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(args: Args) -> Outcome {
    match args.command {
        None => render::default_scene(),
        Some(Command::Render(options)) => render::render(&options),
        Some(Command::Animate(options)) => animate::animate(&options),
        Some(Command::Compare { a, b }) => compare::compare(&a, &b),
        Some(Command::Check { scene }) => scene::check(&scene),
        Some(Command::Compile { scene, output }) => scene::compile(&scene, &output),
        Some(Command::New { name }) => new::new(&name),
        Some(Command::Explain(options)) => explain::explain(&options),
        Some(Command::Gallery(options)) => gallery::gallery(&options),
        Some(Command::Displays) => display::list(),
        Some(Command::Send(options)) => send::send(&options),
        Some(Command::View(options)) => view::view(&options),
    }
}
