//! Runs the program with mutated scenes, pictures and transfers. It must not panic, hang, or take more
//! than 512 MB.
//!
//! The mutations are deterministic: each seed is one input. The environment variable `RUNS` sets the
//! number of seeds. `cargo xtask prove inputs` runs 20,000.
#![cfg(target_os = "linux")]

mod binary;
mod board;
mod program;
mod scene;
mod seeds;

use std::error::Error;
use std::iter;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;

use fastrand::Rng;

use program::Program;
use seeds::Seeds;

type Outcome<T = ()> = Result<T, Box<dyn Error + Send + Sync>>;

#[test]
fn mutated_inputs_do_no_harm() -> Outcome {
    let runs = std::env::var("RUNS").ok();
    let runs = runs.and_then(|runs| runs.parse().ok()).unwrap_or(200);
    let seeds = Seeds::new()?;
    let next = AtomicU64::new(0);
    let threads = thread::available_parallelism()?.get();
    let programs = (0..threads)
        .map(Program::new)
        .collect::<Outcome<Vec<_>>>()?;
    let work = |program: &Program| -> Vec<Result<bool, String>> {
        let seed = || Some(next.fetch_add(1, Ordering::Relaxed)).filter(|seed| *seed < runs);
        let outcomes = iter::from_fn(seed).map(|seed| {
            run(seed, &seeds, program).map_err(|error| format!("seed {seed}: {error}"))
        });
        outcomes.collect()
    };
    let outcomes = thread::scope(|scope| {
        let threads: Vec<_> = programs
            .iter()
            .map(|program| scope.spawn(move || work(program)))
            .collect();
        let outcomes = threads.into_iter().map(|thread| thread.join());
        outcomes.collect::<Result<Vec<_>, _>>()
    });
    let outcomes = outcomes.map_err(|_| "a thread panicked")?.concat();
    let failures: Vec<_> = outcomes.iter().filter_map(|it| it.as_ref().err()).collect();
    assert!(failures.is_empty(), "{failures:#?}");
    let valid = outcomes.iter().filter(|it| **it == Ok(true)).count() as u64;
    println!("figure: {runs} mutated inputs, of which {valid} are valid");
    assert!(10 * valid > runs, "too few are valid: {valid} of {runs}");
    Ok(())
}

/// Runs the program with the input of a seed. Returns true if the input is valid.
fn run(seed: u64, seeds: &Seeds, program: &Program) -> Outcome<bool> {
    let rng = &mut Rng::with_seed(seed);
    match seed % 10 {
        0..6 => program.scene(&scene::mutated(rng, &seeds.scenes)),
        6 => program.compiled(&binary::mutated_scene(rng, &seeds.compiled)),
        7 | 8 => program.pictures(&binary::mutated_png(rng, &seeds.pictures), &seeds.pictures),
        _ => Ok(board::receives(&binary::mutated_transfer(
            rng,
            &seeds.compiled,
        ))),
    }
}
