//! Runs the program `sim` and checks its output, files and exit codes.

mod animate;
mod check;
mod directory;
mod errors;
mod frames;
mod inputs;
mod new;
mod render;
mod scene;
mod stats;
