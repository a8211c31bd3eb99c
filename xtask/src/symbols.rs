//! Which source a firmware's instructions come from.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use addr2line::{Loader, demangle_auto};
use anyhow::{Result, anyhow};
use object::read::elf::ElfFile32;
use object::{Object, ObjectSection, ObjectSymbol, SectionKind, SymbolKind};

use crate::calls::branches;
use crate::root;

/// The debug information of an ELF file.
pub(crate) struct Symbols {
    loader: Loader,
    /// Sections with code: address and bytes.
    code: Vec<(u64, Vec<u8>)>,
    /// Where functions start, in order, and their names.
    functions: Vec<(u64, String)>,
}

/// A function, perhaps inlined, and the line in it.
pub(crate) struct Frame {
    pub(crate) function: String,
    /// From the root of the project, for a file of the project's.
    pub(crate) file: String,
    pub(crate) line: u32,
}

impl Frame {
    /// Whether it is of the library.
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
            .map(|section| Ok((section.address(), section.data()?.to_vec())))
            .collect::<Result<_>>()?;
        let mut functions: Vec<_> = file
            .symbols()
            .filter(|symbol| symbol.kind() == SymbolKind::Text && symbol.size() > 0)
            .map(|symbol| {
                let name = symbol.name().unwrap_or_default();
                // Bit 0 says that the code is Thumb.
                (
                    symbol.address() & !1,
                    demangle_auto(name.into(), None).into_owned(),
                )
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

    /// The frames at an address, the innermost first.
    pub(crate) fn frames(&self, address: u64) -> Result<Vec<Frame>> {
        let text = |error| anyhow!("debug information: {error}");
        let root = format!("{}/", root().display());
        let mut found = Vec::new();
        let mut frames = self.loader.find_frames(address).map_err(text)?;
        while let Some(frame) = frames.next().map_err(|error| anyhow!("{error}"))? {
            let function = frame.function.map_or_else(String::new, |function| {
                function
                    .demangle()
                    .map_or_else(|_| String::new(), |name| name.into_owned())
            });
            let (file, line) = frame.location.map_or(("", 0), |location| {
                (location.file.unwrap_or(""), location.line.unwrap_or(0))
            });
            found.push(Frame {
                function,
                file: file.strip_prefix(&root).unwrap_or(file).to_owned(),
                line,
            });
        }
        Ok(found)
    }

    /// The function of the symbol table that an address lies in.
    pub(crate) fn symbol(&self, address: u64) -> &str {
        self.function(address).map_or("?", |(_, name)| name)
    }

    /// Where a function of the symbol table starts.
    pub(crate) fn address_of(&self, function: &str) -> Option<u64> {
        let mut functions = self.functions.iter();
        functions.find_map(|(start, name)| (name == function).then_some(*start))
    }

    /// Bytes of code that come of a line of the library, inlined or not, by the functions
    /// of the symbol table that they are in.
    pub(crate) fn library_sizes(&self) -> Result<BTreeMap<u64, u64>> {
        /// The shortest instruction.
        const STEP: u64 = 2;
        let mut sizes = BTreeMap::new();
        for (start, bytes) in &self.code {
            let end = start + bytes.len() as u64;
            for address in (*start..end).step_by(STEP as usize) {
                if self.frames(address)?.iter().any(Frame::is_library) {
                    *sizes.entry(self.start_of(address)).or_default() += STEP;
                }
            }
        }
        Ok(sizes)
    }

    /// Where the functions start that are called from some, those included.
    pub(crate) fn called_from(&self, roots: &[&str]) -> BTreeSet<u64> {
        let mut calls = BTreeMap::<u64, Vec<u64>>::new();
        for (start, bytes) in &self.code {
            for (from, to) in branches(bytes, *start) {
                if self.start_of(to) == to {
                    calls.entry(self.start_of(from)).or_default().push(to);
                }
            }
        }
        let is_root = |name: &str| roots.iter().any(|root| name.contains(root));
        let mut waiting: Vec<_> = self
            .functions
            .iter()
            .filter_map(|(start, name)| is_root(name).then_some(*start))
            .collect();
        let mut found = BTreeSet::new();
        while let Some(function) = waiting.pop() {
            if found.insert(function) {
                waiting.extend(calls.get(&function).into_iter().flatten());
            }
        }
        found
    }

    /// Where the function of the symbol table starts that an address lies in.
    fn start_of(&self, address: u64) -> u64 {
        self.function(address).map_or(0, |(start, _)| *start)
    }

    fn function(&self, address: u64) -> Option<&(u64, String)> {
        let next = self
            .functions
            .partition_point(|(start, _)| *start <= address);
        self.functions.get(next.checked_sub(1)?)
    }
}
