//! The cost model: the price of each thing that a frame asks for, on each core.
//!
//! Frames are drawn on the cores in QEMU, which counts their instructions, and
//! on this machine, which counts what they ask for. The prices are those that
//! explain the ones by the others, by least squares.

mod count;
mod crowd;
mod cycles;
mod document;
mod fit;
mod least_squares;
mod mix;
mod room;
mod subject;
mod thumb;

#[path = "../../tests/random_scenes/generator.rs"]
#[allow(dead_code, reason = "the tests ask more of it")]
mod generator;

use std::fs;

use anyhow::Result;

use crate::bench::toolchain;
use crate::root;
use count::count;
use fit::Fit;

/// Finds the prices, and writes them and the document about them.
pub fn run() -> Result<()> {
    let toolchain = toolchain()?;
    let mixes = mix::measure()?;
    let samples = count(&subject::all()?)?;
    let fit = Fit::new(&samples, &mixes, &toolchain);
    fs::write(root().join("sim/cost.toml"), fit.model.to_string())?;
    let document = document::write(&fit, &mixes)?;
    fs::write(root().join("docs/cost-model.md"), &document)?;
    print!("{document}");
    Ok(())
}
