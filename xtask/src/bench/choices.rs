use anyhow::{Result, ensure};

use crate::core::Core;
use crate::firmware::Firmware;
use crate::qemu::Machine;
use crate::size::usage;

/// A program of the rig `choices`.
struct Choice {
    program: &'static str,
    /// The program that the cost of the choice is relative to, or `None` for the simplest program.
    base: Option<&'static str>,
    title: &'static str,
}

const fn choice(program: &'static str, base: &'static str, title: &'static str) -> Choice {
    Choice {
        program,
        base: Some(base),
        title,
    }
}

/// Programs in docs/flash.md.
const CHOICES: [Choice; 8] = [
    Choice {
        program: "compiled",
        base: None,
        title: "decode a compiled scene and draw it",
    },
    choice("authored", "compiled", "prepare a scene in code instead"),
    choice("animated", "authored", "animate a scene in code"),
    choice("orbit", "compiled", "orbit the camera"),
    choice("steps", "compiled", "draw in steps of some rays instead"),
    choice("antialiased", "compiled", "smooth edges instead"),
    choice("srgb", "compiled", "encode sRGB"),
    choice("error_text", "compiled", "format errors as text"),
];

/// Cores in docs/flash.md.
pub(super) const CORES: [Core; 2] = [Core::M0, Core::M3];

/// Most flash that preparing a scene in code may take on the Cortex-M3, compared with decoding a
/// compiled scene.
const MOST_FOR_AUTHORED: u64 = 20_000;

/// Flash of a program in bytes.
pub(super) struct Row {
    pub(super) program: &'static str,
    pub(super) title: &'static str,
    /// For each core, the flash of the program.
    pub(super) flash: [u64; CORES.len()],
    /// For each core, the flash of the program that the cost is relative to.
    pub(super) base: Option<[u64; CORES.len()]>,
}

/// Builds all programs.
pub(super) fn measure() -> Result<Vec<Row>> {
    let row = |choice: &Choice| {
        Ok(Row {
            program: choice.program,
            title: choice.title,
            flash: on_all(choice.program)?,
            base: choice.base.map(on_all).transpose()?,
        })
    };
    CHOICES.iter().map(row).collect()
}

fn on_all(program: &'static str) -> Result<[u64; CORES.len()]> {
    let [m0, m3] = CORES.map(|core| flash(program, core));
    Ok([m0?, m3?])
}

fn flash(program: &'static str, core: Core) -> Result<u64> {
    let firmware = Firmware {
        program,
        ..Machine::of(core).rig("choices")
    };
    Ok(usage(&firmware.build(None)?)?.flash)
}

/// Checks that the macro `real!` takes no flash, and that preparing a scene in code takes at most
/// 20 KB more than decoding a compiled scene.
pub fn check() -> Result<()> {
    let [by_macro, by_bits, authored, compiled] = [
        "numbers_by_macro",
        "numbers_by_bits",
        "authored",
        "compiled",
    ]
    .map(|program| flash(program, Core::M3));
    let (by_macro, by_bits) = (by_macro?, by_bits?);
    println!("a loop with `real!`: {by_macro} bytes of flash, without: {by_bits}");
    ensure!(by_macro == by_bits, "`real!` takes flash");
    let more = authored?.saturating_sub(compiled?);
    println!("a scene in code takes {more} bytes more than a compiled scene");
    ensure!(
        more <= MOST_FOR_AUTHORED,
        "preparing a scene takes more than {MOST_FOR_AUTHORED} bytes"
    );
    Ok(())
}
