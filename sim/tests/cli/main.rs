//! Runs the program `sim` and checks its output, files and exit codes.

mod animate;
mod check;
mod directory;
mod errors;
mod frames;
mod inputs;
#[cfg(unix)]
mod interrupts;
mod new;
mod outputs;
mod render;
mod scene;
mod stats;
#[cfg(unix)]
mod streams;
#[cfg(unix)]
mod terminal;
