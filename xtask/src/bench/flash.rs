//! What of the library's code draws a prepared scene, and what reads a compiled one.

use std::path::Path;

use anyhow::Result;

use crate::symbols::Symbols;

/// Where the headless firmware begins to draw.
const DRAWING: [&str; 2] = ["headless::set_up", "measure::frame::draw"];

/// Where it begins to read a compiled scene, to say what is wrong with it, and to check a
/// picture.
const READING: [&str; 3] = [
    "headless::decode",
    "DecodeError",
    "measure::frame::checksum",
];

/// Bytes of machine code that come of a line of the library, inlined or not.
pub(super) struct Code {
    /// All that is not below.
    pub(super) drawing: u64,
    /// In functions that only reading calls.
    pub(super) reading: u64,
}

impl Code {
    /// That in the headless firmware.
    pub(super) fn of(elf: &Path) -> Result<Self> {
        let symbols = Symbols::load(elf)?;
        let drawing = symbols.called_from(&DRAWING);
        let reading = symbols.called_from(&READING);
        let is_read = |function| reading.contains(function) && !drawing.contains(function);
        let sizes = symbols.library_sizes()?;
        let (reading, drawing): (Vec<_>, Vec<_>) =
            sizes.iter().partition(|(function, _)| is_read(function));
        let sum = |part: Vec<(&u64, &u64)>| part.iter().map(|(_, size)| *size).sum();
        Ok(Self {
            drawing: sum(drawing),
            reading: sum(reading),
        })
    }
}
