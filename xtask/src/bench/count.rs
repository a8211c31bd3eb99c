use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use embedded_graphics_core::geometry::Size;
use whitted::Renderer;
use whitted::observer::Stats;
use whitted_sim::{render, scene_file};

use super::subject::Subject;
use crate::core::Core;
use crate::qemu::{Arithmetic, Machine};
use crate::report::Report;
use crate::{parallel, scene};

/// Measurements of a picture on a core.
pub(super) struct Row {
    pub(super) subject: Subject,
    pub(super) core: Core,
    /// Number of instructions that decode the scene and draw the picture.
    pub(super) instructions: u64,
    /// Number of instructions for the same picture in floating point, or 0 if not counted.
    pub(super) float_instructions: u64,
    /// Total number of camera, reflected, transmitted and shadow rays.
    pub(super) rays: u64,
    /// Flash of the whole firmware in bytes.
    pub(super) flash: u64,
    /// Statics in bytes, without the buffer for the scene file.
    pub(super) ram: u64,
    /// Peak stack in bytes.
    pub(super) stack: u64,
}

/// A picture, the core that draws it, the firmware file that draws it in fixed point, and the
/// optional firmware file that draws it in floating point.
type Job = (Subject, Core, PathBuf, Option<PathBuf>);

/// Draws every picture on every core in fixed point. If `with_float` is true, also draws it in
/// floating point. Returns an error if a fixed-point picture differs from the host's picture.
pub(super) fn count(subjects: &[Subject], cores: &[Core], with_float: bool) -> Result<Vec<Row>> {
    let mut jobs = Vec::new();
    for core in cores.iter().copied() {
        let build = |arithmetic: Arithmetic| Machine::of(core).rig(arithmetic.rig()).build(None);
        let fixed = build(Arithmetic::Fixed)?;
        let float = with_float.then(|| build(Arithmetic::Float)).transpose()?;
        let job = |subject: &Subject| (*subject, core, fixed.clone(), float.clone());
        jobs.extend(subjects.iter().map(job));
    }
    let mut rows = parallel::map(&jobs, row)?;
    rows.sort_by_key(|row| subjects.iter().position(|subject| *subject == row.subject));
    Ok(rows)
}

fn row((subject, core, fixed, float): &Job) -> Result<Row> {
    eprintln!("{subject} on {core}");
    let (subject, core) = (*subject, *core);
    let report = draw(subject, core, Arithmetic::Fixed, fixed)?;
    let (rays, checksum) = draw_on_host(subject)?;
    let drawn = report.get("checksum")?;
    ensure!(
        drawn == checksum,
        "{subject} on {core}: checksum {drawn}, expected {checksum}"
    );
    let mut float_instructions = 0;
    if let Some(float) = float {
        // The float firmware may draw a smaller picture. Its instruction count is then scaled up to
        // the number of pixels of the full picture.
        let small = subject.reduced_for_floats(core);
        let report = draw(small, core, Arithmetic::Float, float)?;
        float_instructions = report.number("instructions")? * subject.pixels() / small.pixels();
    }
    Ok(Row {
        subject,
        core,
        instructions: report.number("instructions")?,
        float_instructions,
        rays,
        flash: report.number("flash")?,
        ram: report.number("statics")? - report.number("file")?,
        stack: report.number("stack")?,
    })
}

fn draw(subject: Subject, core: Core, arithmetic: Arithmetic, elf: &Path) -> Result<Report> {
    let compiled = arithmetic.compile(&scene(subject.scene))?;
    let Size { width, height } = subject.size;
    let report = Machine::of(core).draw(elf, &compiled, &format!("{width}x{height}"))?;
    report.result().with_context(|| subject.to_string())?;
    Ok(report)
}

/// Draws a picture on the host. Returns its number of rays and its checksum.
fn draw_on_host(subject: Subject) -> Result<(u64, String)> {
    let file = scene_file::load(scene(subject.scene))?;
    let mut buffer = Box::new(scene_file::Buffer::new());
    let scene = file.prepare(&mut buffer)?;
    let mut renderer = Renderer::with_observer(&scene, subject.size, Stats::default());
    let picture = render::trace(&mut renderer, |_| {});
    let Stats {
        camera,
        reflected,
        transmitted,
        shadow,
        ..
    } = *renderer.observer();
    let rays = [camera, reflected, transmitted, shadow].map(u64::from);
    Ok((
        rays.iter().sum(),
        format!("{:08x}", render::checksum(&picture)),
    ))
}
