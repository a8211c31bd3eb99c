//! Runs the program `sim` and checks its output, files and exit codes.

mod animate;
mod directory;
mod errors;
mod frames;
mod render;
mod scene;
mod stats;
