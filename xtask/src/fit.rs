//! Fits the cost model of `whitted_sim::cost` to instruction counts from QEMU.

mod least_squares;

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Result;
use embedded_graphics_core::geometry::Size;
use whitted_sim::cost::{ITEMS, Work};
use whitted_sim::scene_file;

use crate::core::Core;
use crate::parallel;
use crate::qemu::{Arithmetic, Machine};
use crate::{root, scenes};
use least_squares::non_negative;

/// Sizes of the pictures whose instructions are counted. Their widths differ, so that the fit can
/// separate the cost of a line from the cost of a pixel.
const SIZES: [Size; 2] = [Size::new(160, 120), Size::new(20, 120)];

/// A picture with its amount of each item of work, and its instruction counts.
struct Sample {
    scene: String,
    size: Size,
    amounts: [u64; ITEMS.len()],
    instructions: [u64; 4],
}

/// Counts the instructions of all scenes, fits the prices, and writes `sim/src/cost/prices.rs`.
pub fn run() -> Result<()> {
    let build = |core| Machine::of(core).rig(Arithmetic::Fixed.rig()).build(None);
    let firmware: Result<Vec<_>> = Core::DISTINCT.into_iter().map(build).collect();
    let firmware = firmware?;
    let mut pictures = Vec::new();
    for scene in scenes()? {
        pictures.extend(SIZES.map(|size| (scene.clone(), size)));
    }
    let samples = parallel::map(&pictures, |(scene, size)| sample(scene, *size, &firmware))?;
    let prices = [0, 1, 2, 3].map(|core| prices(&samples, core));
    let file = root().join("sim/src/cost/prices.rs");
    fs::write(&file, source(&samples, &prices)?)?;
    println!(
        "wrote {}; `cargo test -p whitted-sim` checks the errors",
        file.display()
    );
    Ok(())
}

fn sample(scene: &Path, size: Size, firmware: &[PathBuf]) -> Result<Sample> {
    let file = scene_file::load(scene)?;
    let mut buffer = Box::new(scene_file::Buffer::new());
    let amounts = Work::of(&file.prepare(&mut buffer)?, size).amounts();
    let compiled = Arithmetic::Fixed.compile(scene)?;
    let scene = scene.file_stem().unwrap_or_default().display().to_string();
    let picture = format!("{}x{}", size.width, size.height);
    println!("{scene} {picture}");
    let mut instructions = [0; 4];
    for ((count, core), elf) in instructions.iter_mut().zip(Core::DISTINCT).zip(firmware) {
        let report = Machine::of(core).draw(elf, &compiled, &picture)?;
        *count = report.result()?.number("instructions")?;
    }
    Ok(Sample {
        scene,
        size,
        amounts,
        instructions,
    })
}

/// Returns the price of each item of work on a core, in instructions. With these prices, the sum of
/// the squared relative errors of the instruction counts is minimal.
fn prices(samples: &[Sample], core: usize) -> [u32; ITEMS.len()] {
    let row = |sample: &Sample| {
        let counted = sample.instructions[core] as f64;
        sample.amounts.map(|amount| amount as f64 / counted)
    };
    let rows: Vec<_> = samples.iter().map(row).collect();
    non_negative(&rows).map(|price| price.round() as u32)
}

/// Returns the Rust source of `prices.rs`.
fn source(samples: &[Sample], prices: &[[u32; ITEMS.len()]; 4]) -> Result<String> {
    let mut text = "\
//! Written by `cargo xtask fit`; do not edit.

use super::work::ITEMS;

/// Instructions for one of each item on the M0+, M3, M4F and M33.
#[rustfmt::skip]
pub(super) const PRICES: [[u32; ITEMS.len()]; 4] = [
"
    .to_owned();
    for prices in prices {
        writeln!(text, "    {prices:?},")?;
    }
    let intro = "];

/// Scenes, sizes, and instructions on the M0+, M3, M4F and M33, counted by QEMU.
#[rustfmt::skip]
";
    let count = samples.len();
    writeln!(
        text,
        "{intro}pub const COUNTED: [(&str, [u32; 2], [u32; 4]); {count}] = ["
    )?;
    for sample in samples {
        let Size { width, height } = sample.size;
        let (scene, counts) = (&sample.scene, sample.instructions);
        writeln!(text, "    ({scene:?}, [{width}, {height}], {counts:?}),")?;
    }
    Ok(text + "];\n")
}
