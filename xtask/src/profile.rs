//! Where the instructions of a frame go: QEMU logs every one, and the debug
//! information tells which function and line of the library it belongs to.

mod executed;
mod tally;

use std::collections::HashMap;
use std::path::Path;

use anyhow::{Result, bail};

use crate::qemu::{Arithmetic, Core, Machine};
use crate::symbols::Symbols;
use executed::Step;
use tally::Tally;

pub(crate) use executed::executed;

/// The function that is called when the frame is drawn.
pub(crate) const AFTER_THE_FRAME: &str = "measure::frame::checksum";

/// How many functions and lines are worth a look.
const TOP: usize = 30;

/// Counts, and prints the functions and lines that take the most.
pub fn run(scene: &Path, core: Core, size: &str) -> Result<()> {
    let machine = Machine::of(core);
    let elf = machine.firmware(Arithmetic::Fixed).build(None)?;
    let compiled = Arithmetic::Fixed.compile(scene)?;
    let symbols = Symbols::load(&elf)?;
    let Some(end) = symbols.address_of(AFTER_THE_FRAME) else {
        bail!("{AFTER_THE_FRAME} is not in the firmware");
    };
    let counts = executed(machine.drawing(&elf, &compiled, size), end)?;
    print!("{}", report(&counts, &symbols)?);
    Ok(())
}

fn report(counts: &HashMap<Step, u64>, symbols: &Symbols) -> Result<String> {
    let (mut functions, mut lines) = (Tally::default(), Tally::default());
    for ((address, _), count) in counts {
        let frames = symbols.frames(*address)?;
        // Number formats and `core` say little: what of the library asked for
        // them says more. Routines of the compiler are nobody's but their own.
        match frames.iter().find(|frame| frame.is_library()) {
            Some(frame) => {
                // Without types, which are long.
                let name = frame.function.split('<').next().unwrap_or_default();
                functions.add(format!("{} {name}", frame.file), *count);
                lines.add(format!("{}:{}", frame.file, frame.line), *count);
            }
            None => functions.add(symbols.symbol(*address).to_owned(), *count),
        }
    }
    let total: u64 = counts.values().sum();
    Ok(format!(
        "{total} instructions\n\n{}\n{}",
        functions.top(TOP, total),
        lines.top(TOP, total)
    ))
}
