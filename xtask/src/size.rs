//! Measures the flash and RAM of firmware.

use std::fs;
use std::path::Path;

use anyhow::Result;
use object::read::elf::ElfFile32;
use object::{Object, ObjectSection, SectionFlags, SectionKind, elf::SHF_ALLOC};

use crate::firmware::{Firmware, LM3S6965EVB, TARGETS};

/// Start address of RAM on every Cortex-M.
const RAM: u64 = 0x2000_0000;

/// Flash and RAM that firmware takes, in bytes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Usage {
    /// Flash for the interrupt vectors, the code, the constants, and the initial values of statics.
    pub flash: u64,
    /// RAM of statics, without the stack.
    pub ram: u64,
}

/// Builds the LM3S6965 firmware and the headless firmware. Prints how much flash and RAM each
/// takes.
pub fn print() -> Result<()> {
    let headless = TARGETS.map(|target| Firmware::new("headless", target));
    for firmware in [LM3S6965EVB].into_iter().chain(headless) {
        let Usage { flash, ram } = usage(&firmware.build(None)?)?;
        let Firmware {
            package, target, ..
        } = firmware;
        println!("{package:12} {target:26} {flash:7} bytes of flash, {ram:7} of static RAM");
    }
    Ok(())
}

/// Returns flash and RAM of the firmware in an ELF file.
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
