//! Draws pictures in QEMU, in fixed point and in floating point, and counts the instructions.

mod choices;
mod count;
mod flash;
mod page;
mod subject;

use anyhow::{Result, ensure};

use crate::board;
use crate::budget::{Budget, Counts};
use crate::core::Core;
use crate::firmware::LM3S6965EVB;
use crate::size::usage;
pub use choices::check as check_choices;
use count::count;
use flash::Flash;
use subject::{IN_BUDGET, SUBJECTS};

const BUDGET: Budget = Budget {
    file: "xtask/budget.json",
    bless: "cargo xtask bench --bless",
};

/// Draws a scene on all cores, counts the instructions, and prints a table.
pub fn print(scene: &str) -> Result<()> {
    let mut subjects = SUBJECTS.to_vec();
    subjects.retain(|subject| subject.scene == scene);
    let scenes = SUBJECTS.map(|subject| subject.scene).join(", ");
    ensure!(!subjects.is_empty(), "unknown scene; there are {scenes}");
    print!("{}", page::frames(&count(&subjects, &Core::ALL, true)?)?);
    Ok(())
}

/// Measures the instructions of all pictures and the size of all firmware. Writes the results to
/// the tables of docs/benchmarks.md.
pub fn write() -> Result<()> {
    let rows = count(&SUBJECTS, &Core::ALL, true)?;
    page::replace("frames", &page::frames(&rows)?)?;
    let flash: Result<Vec<_>> = Core::ALL.into_iter().map(Flash::of).collect();
    page::replace("flash", &page::flash(&rows, &flash?)?)?;
    let mut boards = board::flash()?;
    boards.push((LM3S6965EVB.package, usage(&LM3S6965EVB.build(None)?)?));
    page::replace("boards", &page::boards(&boards)?)?;
    page::replace_in(
        page::FLASH,
        "choices",
        &page::choices(&choices::measure()?)?,
    )
}

/// Measures what each choice of a program costs in flash. Writes the table of docs/flash.md.
pub fn write_choices() -> Result<()> {
    page::replace_in(
        page::FLASH,
        "choices",
        &page::choices(&choices::measure()?)?,
    )
}

/// Returns an error if a picture takes more instructions than its budget.
pub fn check() -> Result<()> {
    BUDGET.check(&counts()?)
}

/// Stores the counted instructions as the budget.
pub fn bless() -> Result<()> {
    BUDGET.bless(&counts()?)
}

/// Counts the instructions of three small pictures on the M0, M3 and M4F, and the flash of the
/// programs of the rig `choices` on the M3.
fn counts() -> Result<Counts> {
    let choices = choices::measure()?;
    let [_, m3] = choices::CORES;
    let flash = choices
        .iter()
        .map(|row| (format!("flash {} {m3}", row.program), row.flash[1]));
    let rows = count(&IN_BUDGET, &[Core::M0, Core::M3, Core::M4f], false)?;
    let name = |row: &count::Row| format!("{} {}", row.subject, row.core);
    Ok(rows
        .iter()
        .map(|row| (name(row), row.instructions))
        .chain(flash)
        .collect())
}
