//! Runs the fuzz targets of `fuzz/` on stable Rust: with every input of the
//! corpus, and with random inputs.

#[path = "../fuzz/src/lib.rs"]
#[allow(unreachable_pub, reason = "the fuzz targets need it public")]
mod targets;

use std::fs;
use std::path::Path;

use fastrand::Rng;

/// Returns the number of random inputs: the environment variable `RUNS`, as in
/// `RUNS=1000000 cargo test --test all fuzz`, or `default`.
fn runs(default: u64) -> u64 {
    let runs = std::env::var("RUNS").ok();
    runs.and_then(|runs| runs.parse().ok()).unwrap_or(default)
}

/// Runs a fuzz target with each input of its corpus, and requires that it draws
/// at least one. A corpus in an outdated format would be refused entirely.
fn replay(name: &str, target: fn(&[u8]) -> bool) {
    let corpus = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus");
    let inputs = fs::read_dir(corpus.join(name)).unwrap();
    let mut drawn = 0;
    for input in inputs {
        let path = input.unwrap().path();
        println!("{}", path.display());
        drawn += u32::from(target(&fs::read(path).unwrap()));
    }
    assert!(drawn > 0, "every input in the corpus of {name} is refused");
}

fn random_bytes(seed: u64) -> Vec<u8> {
    let mut rng = Rng::with_seed(seed);
    let length = rng.usize(0..1200);
    (0..length).map(|_| rng.u8(..)).collect()
}

/// Runs the oracle target, which checks every input and refuses none.
fn oracle(input: &[u8]) -> bool {
    targets::oracle(input);
    true
}

macro_rules! corpora {
    ($($test:ident: $name:literal, $target:expr;)*) => {$(
        #[test]
        fn $test() {
            replay($name, $target);
        }
    )*};
}

corpora! {
    corpus_scene_text: "scene_text", targets::scene_text;
    corpus_compiled: "compiled", targets::compiled;
    corpus_display_stream: "display_stream", targets::display_stream;
    corpus_serial: "serial", targets::serial;
    corpus_extremes: "extremes", targets::extremes;
    corpus_oracle: "oracle", oracle;
}

/// Scenes with numbers at the ends of their ranges must be refused or drawn, but
/// not panic. The test build checks for overflow.
#[test]
fn random_extreme_scenes_do_not_panic() {
    let runs = runs(1000);
    let (mut drawn, mut panicked) = (0, Vec::new());
    for seed in 0..runs {
        let input = random_bytes(seed);
        match std::panic::catch_unwind(|| targets::extremes(&input)) {
            Ok(is_drawn) => drawn += u64::from(is_drawn),
            Err(_) => panicked.push(seed),
        }
    }
    println!("figure: {runs} scenes at the extremes, of which {drawn} are valid and drawn");
    assert!(panicked.is_empty(), "seeds {panicked:?}");
    assert!(4 * drawn > runs, "too few are valid: {drawn} of {runs}");
}
