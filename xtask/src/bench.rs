//! What a picture costs: instructions, next to those of the yardstick in
//! floating point; flash, RAM and stack.

mod budget;
mod count;
mod document;
mod flash;
mod growth;
mod section;
mod subject;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result, ensure};

use crate::command::command;
use crate::qemu::{Arithmetic, Core, Machine};
use count::count;
use flash::Code;
use subject::{SUBJECTS, Subject};

pub use budget::{bless, check};
pub use count::Row;
pub use growth::run as growth;

/// Counts, and prints the document of what was found. Where nothing was left
/// out it replaces its section of docs/benchmarks.md, and growth is counted too.
pub fn run(scene: Option<&str>, core: Option<Core>, json: Option<&Path>) -> Result<()> {
    let subjects: Vec<Subject> = SUBJECTS
        .into_iter()
        .filter(|subject| scene.is_none_or(|scene| scene == subject.scene))
        .collect();
    ensure!(
        !subjects.is_empty(),
        "no scene of the benchmark has this name"
    );
    let cores = core.map_or_else(|| Core::ALL.to_vec(), |core| vec![core]);

    let rows = count(&subjects, &cores, &[Arithmetic::Fixed, Arithmetic::Float])?;
    let mut code = BTreeMap::new();
    for core in cores {
        let elf = Machine::of(core).firmware(Arithmetic::Fixed).build(None)?;
        code.insert(core, Code::of(&elf)?);
    }
    if let Some(file) = json {
        fs::write(file, serde_json::to_string_pretty(&rows)? + "\n")
            .with_context(|| file.display().to_string())?;
    }
    let document = document::write(&rows, &code, &toolchain()?);
    print!("{document}");
    if scene.is_none() && core.is_none() {
        section::replace("frames", &document)?;
        growth()?;
    }
    Ok(())
}

/// The compiler, on which counts depend.
pub(crate) fn toolchain() -> Result<String> {
    let output = command("rustc").arg("--version").output()?;
    Ok(String::from_utf8(output.stdout)?.trim().to_owned())
}
