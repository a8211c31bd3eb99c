//! What firmware on someone's shelf relies on, proven as far as can be:
//! `cargo xtask prove`. The report is docs/trust.md.

mod bounds;
mod everywhere;
mod figures;
mod fuzz;
mod mutants;
pub(crate) mod panics;
mod report;
mod soak;
mod supply;
mod tools;

use std::time::Instant;

use anyhow::{Result, bail, ensure};

use figures::figures;

/// Something that is promised.
struct Promise {
    /// Its name in one word, by which it is chosen.
    name: &'static str,
    /// What is promised.
    says: &'static str,
    /// How that is tested.
    how: &'static str,
    /// Tests it, and returns the figures.
    prove: fn() -> Result<String>,
}

/// In the order in which they would be missed.
const PROMISES: [Promise; 10] = [
    Promise {
        name: "panics",
        says: "Nothing panics.",
        how: "`tests/rigs/nopanic` calls every public function with input that the compiler cannot know; its panic \
              handler calls a function that is nowhere, so it links only if no panic is left.",
        prove: panics::prove,
    },
    Promise {
        name: "damage",
        says: "A damaged scene is refused.",
        how: "Every bit flipped and every truncation of each compiled scene of `scenes` (`tests/compiled.rs`).",
        prove: || figures("compiled", &[]),
    },
    Promise {
        name: "overflow",
        says: "Nothing overflows.",
        how: "Random scenes with numbers at the ends of their ranges, compiled with `overflow-checks` \
              and debug assertions (`tests/fuzz`); a million random values per primitive \
              against exact integers (`src/num`, `src/exact.rs`).",
        prove: overflow,
    },
    Promise {
        name: "pictures",
        says: "Pictures are right.",
        how: "A thousand random scenes of every surface, at 320x240, against a tracer in double precision that reads the \
              same files by itself (`tests/random_scenes`).",
        prove: || figures("random_scenes", &[]),
    },
    Promise {
        name: "everywhere",
        says: "Every target draws the same bits.",
        how: "Checksums of all scenes on the host, on five Cortex-M and a RISC-V core in QEMU, and in WebAssembly; \
              of one scene in Miri, as on a big-endian MIPS, which the library's own tests pass, too.",
        prove: everywhere::prove,
    },
    Promise {
        name: "bounds",
        says: "Stack and rays are bounded.",
        how: "The worst of scenes (32 generations, glass in glass, mirrors, flakes) on the M0+ and the M3, the stack painted.",
        prove: bounds::prove,
    },
    Promise {
        name: "soak",
        says: "Nothing wears.",
        how: "10,000 frames of an animation on the M0+ and the M3 in QEMU (`tests/rigs/soak`): the checksum of each is \
              that of the host, and the painted stack gets no deeper after the first loop of it, 54 frames.",
        prove: soak::prove,
    },
    Promise {
        name: "fuzz",
        says: "Any input is refused or drawn.",
        how: "cargo-fuzz, with `overflow-checks`: scene text, compiled bytes, extreme scenes, what is sent to displays, serial lines, random scenes against \
              the oracle. What it has found is in `fuzz/corpus`, which `cargo test` replays.",
        prove: fuzz::prove,
    },
    Promise {
        name: "supply",
        says: "The crate is sound as published.",
        how: "cargo-deny: licenses, sources, duplicates, advisories; `cargo package` builds what is packed; \
              the oldest toolchain that is promised checks it.",
        prove: supply::prove,
    },
    Promise {
        name: "mutants",
        says: "The tests bite.",
        how: "cargo-mutants over arithmetic, shapes, shading and tracing, a fixed sample, against the fast tests.",
        prove: mutants::prove,
    },
];

/// Proves the promises whose names contain one of the words, or all; writes the
/// report of those that hold.
pub fn run(words: &[String]) -> Result<()> {
    let chosen = |name: &str| words.is_empty() || words.iter().any(|word| name.contains(word));
    let promises = PROMISES.iter().filter(|promise| chosen(promise.name));
    let (mut proven, mut broken) = (0, Vec::new());
    for Promise { name, prove, .. } in promises {
        println!("==> {name}");
        let start = Instant::now();
        match prove() {
            Ok(figures) => {
                report::write(name, &figures)?;
                println!("{figures}");
                proven += 1;
            }
            Err(error) => {
                eprintln!("error: {error:#}");
                broken.push(*name);
            }
        }
        println!("<== {name}: {:.0} s", start.elapsed().as_secs_f32());
    }
    if !broken.is_empty() {
        bail!("not proven: {}", broken.join(", "));
    }
    ensure!(proven > 0, "no promise has such a name");
    Ok(())
}

fn overflow() -> Result<String> {
    let scenes = figures("fuzz", &[("RUNS", "20000")])?;
    let primitives = figures("--lib", &[])?;
    Ok(format!("{scenes}; {primitives}"))
}
