//! What is fuzzed (see `fuzz/`), on stable: every input of the corpus, and
//! random ones.

#![allow(clippy::unwrap_used, clippy::expect_used)]

#[path = "../../fuzz/src/lib.rs"]
#[allow(unreachable_pub, reason = "public where it is fuzzed")]
mod fuzz;

use std::fs;
use std::path::Path;

use fastrand::Rng;

/// Random inputs of each kind; `RUNS=1000000 cargo test --test fuzz` takes more.
fn runs(usual: u64) -> u64 {
    let told = std::env::var("RUNS")
        .ok()
        .and_then(|runs| runs.parse().ok());
    told.unwrap_or(usual)
}

/// Runs each input of the corpus, of which some must be drawn: all are refused
/// if they are in a form that has passed.
fn replay(name: &str, target: fn(&[u8]) -> bool) {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus");
    let inputs = fs::read_dir(corpus.join(name)).unwrap();
    let mut drawn = 0;
    for input in inputs {
        let path = input.unwrap().path();
        println!("{}", path.display());
        drawn += u32::from(target(&fs::read(path).unwrap()));
    }
    assert!(drawn > 0, "nothing in the corpus of {name} is drawn");
}

fn random_bytes(seed: u64) -> Vec<u8> {
    let mut rng = Rng::with_seed(seed);
    let length = rng.usize(0..1200);
    (0..length).map(|_| rng.u8(..)).collect()
}

#[test]
fn scene_texts_of_the_corpus() {
    replay("scene_text", fuzz::scene_text);
}

#[test]
fn compiled_scenes_of_the_corpus() {
    replay("compiled", fuzz::compiled);
}

#[test]
fn display_streams_of_the_corpus() {
    replay("display_stream", fuzz::display_stream);
}

#[test]
fn serial_lines_of_the_corpus() {
    replay("serial", fuzz::serial);
}

#[test]
fn extremes_of_the_corpus() {
    replay("extremes", fuzz::extremes);
}

#[test]
fn seeds_of_the_corpus() {
    let oracle = |input: &[u8]| {
        fuzz::oracle(input);
        true
    };
    replay("oracle", oracle);
}

/// Debug assertions and checks of overflow are on in the test build.
#[test]
fn scenes_at_the_extremes_of_every_range_are_refused_or_drawn() {
    let runs = runs(1000);
    let (mut drawn, mut failed) = (0, Vec::new());
    for seed in 0..runs {
        let input = random_bytes(seed);
        match std::panic::catch_unwind(|| fuzz::extremes(&input)) {
            Ok(is_drawn) => drawn += u64::from(is_drawn),
            Err(_) => failed.push(seed),
        }
    }
    println!("figure: {runs} scenes at the extremes, of which {drawn} are valid and drawn");
    assert!(failed.is_empty(), "seeds {failed:?}");
    assert!(4 * drawn > runs, "too few are valid: {drawn} of {runs}");
}
