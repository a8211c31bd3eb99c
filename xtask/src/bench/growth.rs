//! How instructions grow with the spheres in view.

mod crowd;
mod page;
mod plot;

use std::fs;
use std::path::Path;
use std::thread;

use anyhow::{Context, Result, ensure};

use super::section;
use crate::firmware::CROWD;
use crate::qemu::{Arithmetic, Core, Machine};
use crate::{root, scratch_dir};
use crowd::{Crowd, Rays, SIDES};

/// The plot, as the document names it.
const PLOT: &str = "images/growth.svg";

/// What was counted for a number of spheres.
struct Row {
    spheres: u32,
    /// Spheres that a line of pixels shows, on average.
    per_line: f64,
    /// Eye, reflected and shadow rays.
    queries: u64,
    /// Tests of a ray against a sphere.
    tests: u64,
    /// Instructions of a frame, as in [`Rays::ALL`].
    instructions: [u64; 3],
}

impl Row {
    /// Instructions of the whole picture.
    fn whole(&self) -> u64 {
        let [.., whole] = self.instructions;
        whole
    }
}

/// Counts, writes the section of the document and the plot in it, and prints
/// the section.
pub fn run() -> Result<()> {
    let elf = CROWD.build(None)?;
    let rows: Vec<Row> = SIDES
        .into_iter()
        .map(|side| count(side, &elf))
        .collect::<Result<_>>()?;
    let page = page::write(&rows);
    fs::write(root().join("docs").join(PLOT), plot::draw(&rows)?)?;
    section::replace("growth", &page)?;
    print!("{page}");
    Ok(())
}

/// All about a crowd of so many spheres a side.
fn count(side: u32, elf: &Path) -> Result<Row> {
    eprintln!("{} spheres", side * side);
    let instructions = thread::scope(|scope| {
        Rays::ALL
            .map(|rays| scope.spawn(move || instructions(Crowd { side, rays }, elf)))
            .map(|thread| thread.join().ok().context("a thread panicked")?)
            .into_iter()
            .collect::<Result<Vec<_>>>()
    })?;
    let (seen, _) = Crowd {
        side,
        rays: Rays::All,
    }
    .drawn_here()?;
    Ok(Row {
        spheres: side * side,
        per_line: seen.per_line(),
        queries: seen.queries(),
        tests: seen.stats.intersections,
        instructions: instructions
            .try_into()
            .ok()
            .context("a count for each kind")?,
    })
}

/// Instructions of a frame on the M3, whose picture is that of this machine.
fn instructions(crowd: Crowd, elf: &Path) -> Result<u64> {
    let scene = scratch_dir()?.join(format!("{crowd}.toml"));
    fs::write(&scene, crowd.toml())?;
    let compiled = Arithmetic::Fixed.compile(&scene)?;
    let report = Machine::of(Core::M3).draw(elf, &compiled, crowd::SIZE)?;
    let drawn = report.result()?.get("checksum")?;
    let (_, checksum) = crowd.drawn_here()?;
    ensure!(
        drawn == checksum,
        "{crowd}: checksum {drawn}, not {checksum}"
    );
    report.number("instructions")
}
