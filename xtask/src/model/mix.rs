use std::collections::HashMap;
use std::path::Path;

use anyhow::{Context, Result};
use object::read::elf::ElfFile32;
use object::{Object, ObjectSection, SectionKind};

use super::count::COUNTED;
use super::thumb::{Class, class, is_wide};
use crate::profile::{AFTER_THE_FRAME, executed};
use crate::qemu::{Arithmetic, Core, Machine};
use crate::root;
use crate::symbols::Symbols;

/// What is run for the mix: common surfaces, and all of them.
const SCENES: [&str; 2] = ["four_spheres", "every_surface"];

/// Small, as every instruction is logged.
const SIZE: &str = "16x12";

/// How often instructions of a class are executed, and whether another than the
/// next in memory follows.
#[derive(Clone, Debug, Default)]
pub(super) struct Mix(HashMap<(Class, bool), u64>);

impl Mix {
    /// The mean of a price of instructions.
    pub(super) fn mean(&self, price: impl Fn(Class, bool) -> f64) -> f64 {
        let count: u64 = self.0.values().sum();
        let entries = self.0.iter();
        let sum: f64 = entries
            .map(|((class, is_taken), count)| *count as f64 * price(*class, *is_taken))
            .sum();
        sum / count.max(1) as f64
    }

    /// The share of instructions that are such.
    pub(super) fn share(&self, is_such: impl Fn(Class, bool) -> bool) -> f64 {
        self.mean(|class, is_taken| f64::from(u8::from(is_such(class, is_taken))))
    }
}

/// The mix of each core that has code of its own.
pub(super) fn measure() -> Result<Vec<(Core, Mix)>> {
    let of = |core| Ok((core, mix(core)?));
    COUNTED.into_iter().map(of).collect()
}

fn mix(core: Core) -> Result<Mix> {
    let machine = Machine::of(core);
    let elf = machine.firmware(Arithmetic::Fixed).build(None)?;
    let end = Symbols::load(&elf)?.address_of(AFTER_THE_FRAME);
    let end = end.with_context(|| format!("{AFTER_THE_FRAME} is not in the firmware"))?;
    let code = Code::load(&elf)?;
    let mut mix = Mix::default();
    for scene in SCENES {
        let file = root().join("scenes").join(scene).with_extension("toml");
        let compiled = Arithmetic::Fixed.compile(&file)?;
        for ((from, to), count) in executed(machine.drawing(&elf, &compiled, SIZE), end)? {
            let (first, second) = (code.halfword(from), code.halfword(from + 2));
            let next = from + if is_wide(first) { 4 } else { 2 };
            let kind = (class(first, second), to != next);
            *mix.0.entry(kind).or_default() += count;
        }
    }
    Ok(mix)
}

/// The firmware's code: address and bytes of each section.
struct Code(Vec<(u64, Vec<u8>)>);

impl Code {
    fn load(elf: &Path) -> Result<Self> {
        let bytes = std::fs::read(elf)?;
        let file: ElfFile32 = ElfFile32::parse(bytes.as_slice())?;
        let sections = file
            .sections()
            .filter(|section| section.kind() == SectionKind::Text);
        let code = sections.map(|section| Ok((section.address(), section.data()?.to_vec())));
        Ok(Self(code.collect::<Result<_>>()?))
    }

    /// At an address; a NOP where there is no code.
    fn halfword(&self, address: u64) -> u16 {
        let found = self.0.iter().find_map(|(start, bytes)| {
            let offset = usize::try_from(address.checked_sub(*start)?).ok()?;
            bytes.get(offset..offset + 2)
        });
        found.map_or(0xbf00, |bytes| u16::from_le_bytes([bytes[0], bytes[1]]))
    }
}
