//! POV-Ray and `cargo sim render` on the same sphereflake: whole processes,
//! their time and memory, and how like the pictures are.

mod flake;
mod process;
mod scene;

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use whitted_sim::{compare, png16};

use crate::command::{cargo, command, run as run_command};
use crate::{root, scratch_dir, target_dir};
use process::price;

/// The program.
const POVRAY: &str = "povray";

/// A gigabyte of POV-Ray's memory; the next would take a dozen.
const DEEPEST: u32 = 6;

/// Of the pictures, in pixels.
const SIZE: [u32; 2] = [320, 240];

/// Times both on the flake of this depth, each with the scene in the form that
/// it reads, and prints what they took.
pub fn run(depth: u32) -> Result<()> {
    ensure!(
        depth <= DEEPEST,
        "POV-Ray would hold 39 million spheres and more: at most --depth {DEEPEST}"
    );
    let version = version()?;
    run_command(cargo().args(["build", "--quiet", "--release", "--package", "whitted-sim"]))?;
    let files = Files::write(depth)?;

    let sim = price(&mut files.sim(), &files.log, "time:")?;
    let povray = |threads| {
        let povray = &mut files.povray(threads);
        price(povray, &files.log, "Trace Time:")
    };
    let cores = std::thread::available_parallelism()?.get();
    let [one, all] = [povray(1)?, povray(cores)?];
    // A sphere a line: 200 MB at depth 6.
    fs::remove_file(&files.pov)?;
    let [ours, theirs] = [png16::read(&files.ours)?, png16::read(&files.theirs)?];

    println!("{version}, {}", processor());
    println!("depth {depth}: {} spheres\n", flake::count(depth));
    println!("| | wall clock | of that tracing | processor | memory |");
    println!("|---|--:|--:|--:|--:|");
    println!("| `sim render`, 1 thread | {sim} |");
    println!("| POV-Ray, 1 thread | {one} |");
    println!("| POV-Ray, {cores} threads | {all} |");
    println!("\n{}", compare::compare(&ours, &theirs)?);
    Ok(())
}

/// POV-Ray's version, unless it is not there.
fn version() -> Result<String> {
    let output = command(POVRAY).arg("--version").output();
    let output = output.context("povray is missing; on Debian: sudo apt-get install povray")?;
    // It tells this among its complaints.
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    let line = text.lines().find(|line| line.starts_with("POV-Ray"));
    Ok(line.context("povray tells no version")?.to_owned())
}

/// What runs this, for what the times are worth.
fn processor() -> String {
    let about = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = about.lines().find(|line| line.starts_with("model name"));
    let name = model.and_then(|line| Some(line.split_once(": ")?.1));
    name.unwrap_or("an unknown processor").to_owned()
}

/// The scene in both forms, the pictures of it, and what is printed meanwhile.
struct Files {
    toml: PathBuf,
    pov: PathBuf,
    ours: PathBuf,
    theirs: PathBuf,
    log: PathBuf,
}

impl Files {
    fn write(depth: u32) -> Result<Self> {
        let folder = scratch_dir()?;
        let file = |extension| folder.join(format!("sphereflake_d{depth}.{extension}"));
        let files = Self {
            toml: file("toml"),
            pov: file("pov"),
            ours: file("sim.png"),
            theirs: file("povray.png"),
            log: file("log"),
        };
        let usual = fs::read_to_string(root().join("scenes/sphereflake.toml"))?;
        let toml = usual.replace("\ndepth = 6 ", &format!("\ndepth = {depth} "));
        ensure!(
            depth == 6 || toml != usual,
            "scenes/sphereflake.toml has no depth of 6 to be replaced"
        );
        fs::write(&files.toml, &toml)?;
        let mut pov = BufWriter::new(File::create(&files.pov)?);
        scene::write(&whitted_oracle::parse(&toml), SIZE, &mut pov)
            .and_then(|()| Ok(pov.flush()?))
            .with_context(|| files.pov.display().to_string())?;
        Ok(files)
    }

    /// As the library's references: linear, 16 bits, no branch of the tree of
    /// rays cut off.
    fn sim(&self) -> Command {
        let [width, height] = SIZE;
        let mut sim = command(target_dir().join("release/sim"));
        sim.arg("render").arg(&self.toml);
        sim.args(["--stats", "--linear16", "--min-weight", "0", "--size"]);
        sim.arg(format!("{width}x{height}"));
        sim.arg("--output").arg(&self.ours);
        sim
    }

    /// The same, by so many threads.
    fn povray(&self, threads: usize) -> Command {
        let [width, height] = SIZE;
        let named = |option: &str, file: &Path| format!("{option}{}", file.display());
        let mut povray = command(POVRAY);
        povray.args([named("+I", &self.pov), named("+O", &self.theirs)]);
        povray.args([format!("+W{width}"), format!("+H{height}")]);
        povray.arg(format!("+WT{threads}"));
        // PNG of 16 bits, no window, no antialiasing.
        povray.args(["+FN16", "File_Gamma=1", "-D", "-A"]);
        povray
    }
}
