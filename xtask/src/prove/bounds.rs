//! The worst of scenes, on the cores with the least.

use anyhow::{Result, ensure};

use crate::qemu::{Arithmetic, Core, Machine};
use crate::root;

/// Bytes of stack that the firmware takes at most, the renderer and whatever
/// has started it included.
const STACK: u64 = 6 * 1024;

const SIZE: &str = "4x3";

pub(super) fn prove() -> Result<String> {
    let scene = Arithmetic::Fixed.compile(&root().join("tests/worst/scene.toml"))?;
    let mut figures = Vec::new();
    for core in [Core::M0, Core::M3] {
        let machine = Machine::of(core);
        let elf = machine.firmware(Arithmetic::Fixed).build(None)?;
        let report = machine.draw(&elf, &scene, SIZE)?;
        let stack = report.result()?.number("stack")?;
        ensure!(stack <= STACK, "{stack} bytes of stack on {core}");
        let instructions = report.number("instructions")? / 1_000_000;
        figures.push(format!(
            "{}: {stack} of {STACK} bytes of stack, {instructions} M instructions for {SIZE}",
            core.title()
        ));
    }
    Ok(figures.join("; "))
}
