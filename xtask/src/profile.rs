//! Profiles the drawing of a frame. QEMU logs the address of every instruction. The debug
//! information maps each address to a function and a line of the library.

use std::cmp::Reverse;
use std::collections::HashMap;
use std::path::Path;

use anyhow::{Context, Result};

use crate::core::Core;
use crate::qemu::{Arithmetic, Machine, Running};
use crate::symbols::Symbols;

/// Name of the function that the firmware calls after it has drawn the frame. The profile ends at
/// this call.
const AFTER_THE_FRAME: &str = "measure::frame::checksum";

/// Number of functions and of lines that are printed.
const TOP: usize = 30;

/// Instruction counts by the name of a function or a line.
type Tally = HashMap<String, u64>;

/// Draws a frame and prints the functions and lines that execute the most instructions.
pub fn run(scene: &Path, core: Core, size: &str) -> Result<()> {
    let machine = Machine::of(core);
    let elf = machine.rig(Arithmetic::Fixed.rig()).build(None)?;
    let symbols = Symbols::load(&elf)?;
    let end = symbols
        .address_of(AFTER_THE_FRAME)
        .with_context(|| format!("the firmware has no function {AFTER_THE_FRAME}"))?;
    let mut qemu = machine.drawing(&elf, &Arithmetic::Fixed.compile(scene)?, size);
    // QEMU logs blocks of instructions. With these options, each block has one instruction, and
    // QEMU logs the block each time it runs. QEMU 9.0 renames `-singlestep` to
    // `-accel tcg,one-insn-per-tb=on`.
    qemu.args(["-singlestep", "-d", "exec,nochain", "-D", "/dev/stdout"]);
    let qemu = Running::start(qemu)?;
    let mut counts = HashMap::<u64, u64>::new();
    loop {
        match address(&qemu.line()?) {
            Some(address) if address == end => break,
            Some(address) => *counts.entry(address).or_default() += 1,
            None => {}
        }
    }

    let (mut functions, mut lines) = (Tally::new(), Tally::new());
    for (address, count) in &counts {
        let frames = symbols.frames(*address)?;
        // Functions of the crates `core` and `fixed` may be inlined into a function of the library.
        // Their instructions then count for this library function.
        let function = match frames.iter().find(|frame| frame.is_library()) {
            Some(frame) => {
                let line = format!("{}:{}", frame.file, frame.line);
                *lines.entry(line).or_default() += count;
                let name = frame.function.split('<').next().unwrap_or_default();
                format!("{} {name}", frame.file)
            }
            None => symbols.symbol(*address).to_owned(),
        };
        *functions.entry(function).or_default() += count;
    }
    let total = counts.values().sum();
    println!("{total} instructions");
    print_top(&functions, total);
    print_top(&lines, total);
    Ok(())
}

fn print_top(tally: &Tally, total: u64) {
    let mut entries: Vec<_> = tally.iter().collect();
    entries.sort_by_key(|(name, count)| (Reverse(**count), *name));
    println!();
    for (name, count) in entries.into_iter().take(TOP) {
        let percent = 100.0 * *count as f64 / total as f64;
        println!("{count:12} {percent:5.1} %  {name}");
    }
}

/// Returns the program counter in a line of QEMU's log. In the line `Trace 0: 0x7f0123456789
/// [00000000/00001234/...`, it is 0x1234.
fn address(line: &str) -> Option<u64> {
    let address = line.strip_prefix("Trace")?.split('/').nth(1)?;
    u64::from_str_radix(address, 16).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_the_address_of_a_log_line() {
        let line = "Trace 0: 0x7f8c24000100 [00000000/00001a2c/00000110/ff001201] main";
        assert_eq!(address(line), Some(0x1a2c));
        assert_eq!(address("Linking TBs"), None);
    }
}
