use std::path::Path;

use anyhow::Result;

use crate::core::Core;
use crate::firmware::Firmware;
use crate::qemu::{Arithmetic, Machine};
use crate::symbols::Symbols;

/// Paths of the library code that is only needed to decode scenes. All other code counts as drawing
/// code.
const DECODING: [&str; 6] = [
    "src/archive",
    "src/codec",
    "src/math/crc32",
    "src/prepare/culling",
    "src/scene/error",
    "src/scene_buffer",
];

/// Size of the library's machine code in the headless firmware for a core, in bytes. Each pair has
/// the size of the drawing code, then the size of the code that decodes scenes. Library code that
/// is inlined into other crates is included.
pub(super) struct Flash {
    pub(super) core: Core,
    pub(super) full: [u64; 2],
    /// Sizes if the library has no optional features, and so only spheres and planes.
    pub(super) minimal: [u64; 2],
}

impl Flash {
    pub(super) fn of(core: Core) -> Result<Self> {
        let full = Machine::of(core).rig(Arithmetic::Fixed.rig());
        let minimal = Firmware {
            defaults: false,
            ..full
        };
        Ok(Self {
            core,
            full: code(&full.build(None)?)?,
            minimal: code(&minimal.build(None)?)?,
        })
    }
}

fn code(elf: &Path) -> Result<[u64; 2]> {
    let mut sizes = [0, 0];
    for (file, size) in Symbols::load(elf)?.library_sizes()? {
        let decodes = DECODING.iter().any(|prefix| file.starts_with(prefix));
        sizes[usize::from(decodes)] += size;
    }
    Ok(sizes)
}
