//! How much of a chip firmware takes.

use std::fs;
use std::path::Path;

use anyhow::Result;
use object::read::elf::ElfFile32;
use object::{Object, ObjectSection, SectionFlags, SectionKind, elf::SHF_ALLOC};

use crate::firmware::{HEADLESS, LM3S6965EVB};

/// Where RAM begins on every Cortex-M.
const RAM: u64 = 0x2000_0000;

/// Bytes of flash and of RAM.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Usage {
    /// Vectors, code, constants, and the initial values of statics.
    pub flash: u64,
    /// Statics: all but the stack.
    pub ram: u64,
}

/// Builds all firmware and prints what it takes.
pub fn print() -> Result<()> {
    println!(
        "{:12} {:22} {:>7} {:>7}",
        "firmware", "target", "flash", "statics"
    );
    for firmware in [LM3S6965EVB].into_iter().chain(HEADLESS) {
        let Usage { flash, ram } = usage(&firmware.build(None)?)?;
        println!(
            "{:12} {:22} {flash:7} {ram:7}",
            firmware.package, firmware.target
        );
    }
    Ok(())
}

/// What the firmware in this ELF file takes.
pub fn usage(elf: &Path) -> Result<Usage> {
    let bytes = fs::read(elf)?;
    let elf: ElfFile32 = ElfFile32::parse(bytes.as_slice())?;
    let mut usage = Usage::default();
    for section in elf.sections() {
        let is_loaded = matches!(
            section.flags(),
            SectionFlags::Elf { sh_flags, .. } if sh_flags.contains(SHF_ALLOC)
        );
        if !is_loaded {
            continue;
        }
        if section.kind() != SectionKind::UninitializedData {
            usage.flash += section.size();
        }
        if section.address() >= RAM {
            usage.ram += section.size();
        }
    }
    Ok(usage)
}
