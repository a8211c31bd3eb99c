use std::fs;

use anyhow::{Context, Result, ensure};

use crate::command::cargo;
use crate::target_dir;
use crate::tools::require;

/// Files to mutate: arithmetic, shapes, culling and tracing.
const FILES: [&str; 5] = [
    "src/math/**/*.rs",
    "src/geometry/**/*.rs",
    "src/prepare/culling.rs",
    "src/trace/**/*.rs",
    "src/render/scanline_culler.rs",
];

/// Tests that are run on each mutant.
const TESTS: [&str; 2] = ["--lib", "--test=all"];

/// Tests that are not run on each mutant, because they take too long.
const SLOW: [&str; 5] = [
    "antialias::",
    "compiled::",
    "random_scenes::",
    "reference::",
    "special_scenes::",
];

/// Part of the mutants to test: one in seven of about 2000.
const SHARD: &str = "--shard=0/7";

/// Smallest allowed share of caught mutants, in percent.
const LEAST: usize = 85;

/// Checks with cargo-mutants that tests find deliberate mistakes. A mutant is a copy of the code
/// with one such mistake. The tests run on a sample of the mutants.
pub(super) fn check() -> Result<()> {
    require(&["cargo", "mutants"], "cargo install cargo-mutants")?;
    let folder = target_dir().join("mutants");
    // Removes the lists of mutants from an earlier run.
    _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder)?;
    let mut mutants = cargo();
    mutants.args(["mutants", "--package", "whitted", "--jobs=2"]);
    // Some mutants loop forever, so each test run has a time limit.
    mutants.args(["--timeout=120", "--sharding=round-robin", SHARD]);
    mutants.arg("--output").arg(&folder);
    mutants.args(FILES.map(|file| format!("--file={file}")));
    mutants.args(TESTS.map(|test| format!("--cargo-arg={test}")));
    mutants.args(["--", "--"]);
    mutants.args(SLOW.map(|test| format!("--skip={test}")));
    // Each job of cargo-mutants builds in its own target folder.
    mutants.env_remove("CARGO_TARGET_DIR");
    mutants
        .env("CARGO_PROFILE_DEV_DEBUG", "0")
        .env("RUNS", "200");
    // The exit code of cargo-mutants is ignored, because it is nonzero even if a single mutant is
    // missed. Instead, the caught and missed mutants in its lists are counted.
    mutants.status()?;
    let count = |list: &str| {
        let file = folder.join("mutants.out").join(list).with_extension("txt");
        let names = fs::read_to_string(&file).with_context(|| file.display().to_string())?;
        anyhow::Ok(names.lines().count())
    };
    let caught = count("caught")? + count("timeout")?;
    let viable = caught + count("missed")?;
    println!("{caught} of {viable} viable mutants caught");
    let is_enough = viable > 0 && 100 * caught / viable >= LEAST;
    ensure!(is_enough, "fewer than {LEAST} % are caught");
    Ok(())
}
