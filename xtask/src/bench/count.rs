use std::path::PathBuf;
use std::sync::Mutex;
use std::thread;

use anyhow::{Context, Result, ensure};
use embedded_graphics_core::geometry::Size;
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;
use whitted::Renderer;
use whitted::observer::Stats;
use whitted_sim::{render, scene_file};

use super::subject::Subject;
use crate::qemu::{Arithmetic, Core, Machine};
use crate::report::Report;

/// How many machines run at a time.
const AT_A_TIME: usize = 2;

/// What was counted for a picture on a core.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The scene file's name.
    pub scene: &'static str,
    /// Width and height.
    pub size: String,
    /// The core's short name.
    #[serde(serialize_with = "name")]
    pub core: Core,
    /// Of the frame, the decoding of the scene included.
    pub instructions: u64,
    /// The same in floating point, where that was asked for.
    pub float_instructions: Option<u64>,
    /// Eye, reflected, transmitted and shadow rays.
    pub queries: u64,
    /// Bytes of flash of the whole firmware.
    pub flash: u64,
    /// Bytes of statics, without the buffer for the host's file.
    pub ram: u64,
    /// Bytes of stack at the deepest.
    pub stack: u64,
    /// Pixels of the frame.
    #[serde(skip)]
    pub pixels: u64,
}

fn name<S: serde::Serializer>(core: &Core, to: S) -> Result<S::Ok, S::Error> {
    to.collect_str(core)
}

/// One run of a machine.
#[derive(Clone)]
struct Run {
    subject: Subject,
    core: Core,
    arithmetic: Arithmetic,
    elf: PathBuf,
    scene: PathBuf,
}

/// Draws every picture on every core, and checks that it is the picture that
/// this machine draws.
pub(crate) fn count(
    subjects: &[Subject],
    cores: &[Core],
    arithmetics: &[Arithmetic],
) -> Result<Vec<Row>> {
    let mut runs = Vec::new();
    for arithmetic in arithmetics {
        for core in cores {
            let elf = Machine::of(*core).firmware(*arithmetic).build(None)?;
            for subject in subjects {
                runs.push(Run {
                    subject: *subject,
                    core: *core,
                    arithmetic: *arithmetic,
                    elf: elf.clone(),
                    scene: arithmetic.compile(&subject.file())?,
                });
            }
        }
    }
    let reports = all(&runs)?;
    let found = |subject, core, arithmetic| {
        runs.iter().zip(&reports).find_map(|(run, report)| {
            let is_it = (run.subject, run.core, run.arithmetic) == (subject, core, arithmetic);
            is_it.then_some((run, report))
        })
    };
    let mut rows = Vec::new();
    for subject in subjects {
        let (queries, checksum) = on_this_machine(*subject)?;
        for core in cores {
            let (_, report) =
                found(*subject, *core, Arithmetic::Fixed).context("fixed point is counted")?;
            let drawn = report.get("checksum")?;
            ensure!(
                drawn == checksum,
                "{subject} on {core}: checksum {drawn}, not {checksum}"
            );
            let float = found(*subject, *core, Arithmetic::Float)
                .map(|(run, report)| run.scaled(report))
                .transpose()?;
            rows.push(Row {
                scene: subject.scene,
                size: subject.size(),
                core: *core,
                instructions: report.number("instructions")?,
                float_instructions: float,
                queries,
                flash: report.number("flash")?,
                ram: report.number("statics")? - report.number("file")?,
                stack: report.number("stack")?,
                pixels: subject.pixels(),
            });
        }
    }
    Ok(rows)
}

/// Ray queries of a picture, and its checksum.
fn on_this_machine(subject: Subject) -> Result<(u64, String)> {
    let file = scene_file::load(subject.file())?;
    let mut buffer = Box::new(scene_file::Buffer::new());
    let scene = file.prepare(&mut buffer)?;
    let size = Size::new(subject.width, subject.height);
    let mut renderer = Renderer::with_observer(&scene, size, Stats::default());
    let picture = render::trace(&mut renderer, |_| {});
    let rays = renderer.observer();
    let queries = [rays.camera, rays.reflected, rays.transmitted, rays.shadow];
    let checksum = format!("{:08x}", render::checksum(&picture));
    Ok((queries.into_iter().map(u64::from).sum(), checksum))
}

impl Run {
    fn reduction(&self) -> u32 {
        self.subject.reduction(self.arithmetic, self.core)
    }

    fn report(&self) -> Result<Report> {
        let size = self.subject.reduced(self.reduction()).size();
        let report = Machine::of(self.core).draw(&self.elf, &self.scene, &size)?;
        report.result()?;
        Ok(report)
    }

    /// The instructions that a whole frame would take.
    fn scaled(&self, report: &Report) -> Result<u64> {
        let drawn = self.subject.reduced(self.reduction());
        Ok(report.number("instructions")? * self.subject.pixels() / drawn.pixels())
    }
}

/// The reports of all runs, in their order.
fn all(runs: &[Run]) -> Result<Vec<Report>> {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} {msg}")?;
    let bar = ProgressBar::new(runs.len() as u64).with_style(style);
    let left = Mutex::new(runs.iter().enumerate());
    let next = || left.lock().ok()?.next();
    let work = || {
        let mut done = Vec::new();
        while let Some((index, run)) = next() {
            let what = format!("{} on {} ({:?})", run.subject, run.core, run.arithmetic);
            // Where there is no terminal, a line each.
            if bar.is_hidden() {
                eprintln!("{what}");
            }
            bar.set_message(what);
            done.push((index, run.report()?));
            bar.inc(1);
        }
        anyhow::Ok(done)
    };
    let mut reports = Vec::new();
    thread::scope(|scope| {
        let workers: Vec<_> = (0..AT_A_TIME).map(|_| scope.spawn(work)).collect();
        for worker in workers {
            let done = worker.join().ok().context("a worker panicked")?;
            reports.extend(done?);
        }
        anyhow::Ok(())
    })?;
    bar.finish_and_clear();
    reports.sort_by_key(|(index, _)| *index);
    Ok(reports.into_iter().map(|(_, report)| report).collect())
}
