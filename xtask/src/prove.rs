//! Implements `cargo xtask prove`. It runs the checks of docs/trust.md that take too long for
//! `cargo xtask test`.

mod everywhere;
mod fuzz;
mod interrupts;
mod miri;
mod mutants;
mod supply;

use anyhow::{Result, ensure};

use crate::command::{cargo, run as run_command};
use crate::core::Core;
use crate::qemu::{Arithmetic, Machine};
use crate::soak::soak;
use crate::steps::{self, Step};
use crate::{panics, pico, root};

/// Names of the checks and the functions that run them.
const CHECKS: [Step; 14] = [
    ("panics", panics),
    ("damage", || {
        library_test(&["--test", "all", "compiled"], None)
    }),
    ("overflow", overflow),
    ("pictures", || {
        library_test(&["--test", "all", "random_scenes"], None)
    }),
    ("inputs", inputs),
    ("everywhere", everywhere::check),
    ("miri", miri::check),
    ("bounds", bounds),
    ("soak", soak_cores),
    ("slow-scenes", pico::prove_slow_scenes),
    ("fuzz", fuzz::check),
    ("interrupts", interrupts::check),
    ("supply", supply::check),
    ("mutants", mutants::check),
];

/// Runs the checks whose names contain one of the words, or all checks if there are no words.
pub fn run(words: &[String]) -> Result<()> {
    steps::run(&CHECKS, words)
}

fn panics() -> Result<()> {
    panics::link_all()?;
    panics::link_broken()
}

/// Runs tests of the library and shows their output.
fn library_test(arguments: &[&str], variable: Option<(&str, &str)>) -> Result<()> {
    let mut test = cargo();
    test.args(["test", "--package", "whitted"]).args(arguments);
    run_command(test.args(["--", "--nocapture"]).envs(variable))
}

/// Runs tests that panic on arithmetic overflow. Some tests draw scenes with values at the limits
/// of all ranges. Other tests compare the library's arithmetic with exact integer arithmetic.
fn overflow() -> Result<()> {
    library_test(&["--test", "all", "fuzz"], Some(("RUNS", "20000")))?;
    library_test(&["--lib"], None)
}

/// Runs all commands of the simulator with 20,000 mutated scenes, pictures and transfers, with limits
/// for time and memory.
fn inputs() -> Result<()> {
    let mut test = cargo();
    test.args(["test", "--package", "whitted-sim", "--test", "mutations"]);
    run_command(test.args(["--", "--nocapture"]).env("RUNS", "20000"))
}

/// Checks the peak stack size on the smallest cores. The scene has the deepest possible ray tree.
fn bounds() -> Result<()> {
    /// Largest allowed stack size of the firmware with the renderer, in bytes.
    const STACK: u64 = 6 * 1024;
    let scene = Arithmetic::Fixed.compile(&root().join("tests/stress/scene.toml"))?;
    for core in [Core::M0, Core::M3] {
        let machine = Machine::of(core);
        let elf = machine.rig(Arithmetic::Fixed.rig()).build(None)?;
        let report = machine.draw(&elf, &scene, "4x3")?;
        let stack = report.result()?.number("stack")?;
        println!("{}: {stack} of {STACK} bytes of stack", core.title());
        ensure!(stack <= STACK, "stack of {stack} bytes on {core}");
    }
    Ok(())
}

/// Draws 10,000 frames of an animation on the smallest cores.
fn soak_cores() -> Result<()> {
    for core in [Core::M0, Core::M3] {
        let stack = soak(core, 10_000)?;
        println!("{}: {stack} bytes of stack", core.title());
    }
    Ok(())
}
