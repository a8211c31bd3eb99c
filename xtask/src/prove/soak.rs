//! That nothing wears: many frames on the cores with the least.

use anyhow::Result;

use crate::qemu::Core;
use crate::soak::soak;

const FRAMES: u16 = 10_000;

pub(super) fn prove() -> Result<String> {
    let mut figures = Vec::new();
    for core in [Core::M0, Core::M3] {
        let stack = soak(core, FRAMES)?;
        figures.push(format!("{} bytes of stack on the {}", stack, core.title()));
    }
    Ok(format!("{FRAMES} frames alike; {}", figures.join(", ")))
}
