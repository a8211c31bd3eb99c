//! Maps code addresses of firmware to functions and source lines, by the symbol table and the debug
//! information.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use addr2line::{Loader, demangle_auto};
use anyhow::{Result, anyhow};
use object::read::elf::ElfFile32;
use object::{Object, ObjectSection, ObjectSymbol, SectionKind, SymbolKind};

use crate::root;

/// Symbols and debug information of an ELF file.
pub(crate) struct Symbols {
    loader: Loader,
    /// Address and length of each code section.
    code: Vec<(u64, u64)>,
    /// Start address and name of each function, sorted by address.
    functions: Vec<(u64, String)>,
}

/// One of the functions that contain a code address. It may be inlined into the function of the
/// next frame.
pub(crate) struct Frame {
    pub(crate) function: String,
    /// Path of the source file. If the file belongs to the project, the path is relative to the
    /// root of the project.
    pub(crate) file: String,
    pub(crate) line: u32,
}

impl Frame {
    /// Returns true if the function is in a source file of the library.
    pub(crate) fn is_library(&self) -> bool {
        self.file.starts_with("src/")
    }
}

impl Symbols {
    /// Reads an ELF file.
    pub(crate) fn load(elf: &Path) -> Result<Self> {
        let bytes = fs::read(elf)?;
        let file: ElfFile32 = ElfFile32::parse(bytes.as_slice())?;
        let code = file
            .sections()
            .filter(|section| section.kind() == SectionKind::Text)
            .map(|section| (section.address(), section.size()))
            .collect();
        let mut functions: Vec<_> = file
            .symbols()
            .filter(|symbol| symbol.kind() == SymbolKind::Text && symbol.size() > 0)
            .map(|symbol| {
                let name = demangle_auto(symbol.name().unwrap_or_default().into(), None);
                // Bit 0 of a symbol's address only marks Thumb code. The code itself starts at an
                // even address.
                (symbol.address() & !1, name.into_owned())
            })
            .collect();
        functions.sort();
        let loader = Loader::new(elf).map_err(|error| anyhow!("{}: {error}", elf.display()))?;
        Ok(Self {
            loader,
            code,
            functions,
        })
    }

    /// Returns the functions that contain a code address. The innermost inlined function is first.
    pub(crate) fn frames(&self, address: u64) -> Result<Vec<Frame>> {
        let invalid = |error| anyhow!("debug information: {error}");
        let root = format!("{}/", root().display());
        let mut found = Vec::new();
        let mut frames = self.loader.find_frames(address).map_err(invalid)?;
        while let Some(frame) = frames.next().map_err(|error| anyhow!("{error}"))? {
            let name = frame
                .function
                .and_then(|name| Some(name.demangle().ok()?.into_owned()));
            let location = frame.location.as_ref();
            let file = location.and_then(|location| location.file).unwrap_or("");
            found.push(Frame {
                function: name.unwrap_or_default(),
                file: file.strip_prefix(&root).unwrap_or(file).to_owned(),
                line: location.and_then(|location| location.line).unwrap_or(0),
            });
        }
        Ok(found)
    }

    /// Finds a code address in the symbol table and returns the name of the function.
    pub(crate) fn symbol(&self, address: u64) -> &str {
        let next = self
            .functions
            .partition_point(|(start, _)| *start <= address);
        let last = next
            .checked_sub(1)
            .and_then(|last| self.functions.get(last));
        last.map_or("?", |(_, name)| name)
    }

    /// Returns the start address of a function.
    pub(crate) fn address_of(&self, function: &str) -> Option<u64> {
        let mut functions = self.functions.iter();
        functions.find_map(|(start, name)| (name == function).then_some(*start))
    }

    /// Returns the size of the library code in the firmware for each source file, in bytes. If an
    /// instruction belongs to several inlined library functions, it counts for the file of the
    /// outermost one.
    pub(crate) fn library_sizes(&self) -> Result<BTreeMap<String, u64>> {
        /// Size of the shortest Thumb instruction, in bytes.
        const STEP: u64 = 2;
        let mut sizes = BTreeMap::new();
        for (start, length) in &self.code {
            for address in (*start..start + length).step_by(STEP as usize) {
                let frames = self.frames(address)?;
                if let Some(frame) = frames.into_iter().rfind(Frame::is_library) {
                    *sizes.entry(frame.file).or_default() += STEP;
                }
            }
        }
        Ok(sizes)
    }
}
