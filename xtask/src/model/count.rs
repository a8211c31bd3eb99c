use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Mutex;
use std::thread;

use anyhow::{Context, Result};
use indicatif::ProgressBar;
use whitted_sim::cost::Work;
use whitted_sim::scene_file;

use super::subject::Subject;
use crate::qemu::{Arithmetic, Core, Machine};

/// How many machines run at a time.
const AT_A_TIME: usize = 2;

/// Cores with code of their own; an M7 runs that of the M4F.
pub(super) const COUNTED: [Core; 4] = [Core::M0, Core::M3, Core::M4f, Core::M33];

/// A picture, what it asks for, and the instructions that it took.
#[derive(Clone, Debug)]
pub(super) struct Sample {
    pub(super) subject: Subject,
    pub(super) work: Work,
    pub(super) instructions: BTreeMap<Core, u64>,
}

/// Draws every picture on every core.
pub(super) fn count(subjects: &[Subject]) -> Result<Vec<Sample>> {
    let firmware = COUNTED
        .into_iter()
        .map(|core| {
            Ok((
                core,
                Machine::of(core).firmware(Arithmetic::Fixed).build(None)?,
            ))
        })
        .collect::<Result<Vec<_>>>()?;
    let bar = ProgressBar::new(subjects.len() as u64);
    let left = Mutex::new(subjects.iter().enumerate());
    let next = || left.lock().ok()?.next();
    let work = || {
        let mut done = Vec::new();
        while let Some((index, subject)) = next() {
            let sample = sample(subject, &firmware).with_context(|| subject.name.clone())?;
            done.push((index, sample));
            bar.inc(1);
        }
        anyhow::Ok(done)
    };
    let mut samples = Vec::new();
    thread::scope(|scope| {
        let workers: Vec<_> = (0..AT_A_TIME).map(|_| scope.spawn(work)).collect();
        for worker in workers {
            samples.extend(worker.join().ok().context("a worker panicked")??);
        }
        anyhow::Ok(())
    })?;
    bar.finish_and_clear();
    samples.sort_by_key(|(index, _)| *index);
    Ok(samples.into_iter().map(|(_, sample)| sample).collect())
}

fn sample(subject: &Subject, firmware: &[(Core, PathBuf)]) -> Result<Sample> {
    let file = scene_file::load(&subject.file)?;
    let mut buffer = Box::new(scene_file::Buffer::new());
    let work = Work::of(&file.prepare(&mut buffer)?, subject.size);
    let compiled = Arithmetic::Fixed.compile(&subject.file)?;
    let size = format!("{}x{}", subject.size.width, subject.size.height);
    let mut instructions = BTreeMap::new();
    for (core, elf) in firmware {
        let report = Machine::of(*core).draw(elf, &compiled, &size)?;
        let count = report.result()?.number("instructions")?;
        instructions.insert(*core, count);
    }
    Ok(Sample {
        subject: subject.clone(),
        work,
        instructions,
    })
}
