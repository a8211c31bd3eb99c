//! `cargo xtask`: runs one of the project's tasks.

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::Result;
use clap::{Args, Parser, Subcommand};
use xtask::core::Core;
use xtask::qemu::{Arithmetic, Machine};
use xtask::{bench, board, fit, oled, pico, profile, prove, size, test, tidy};

/// Runs one of the project's tasks.
#[derive(Parser)]
#[command(bin_name = "cargo xtask")]
struct Cli {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// Runs all checks and tests, and installs missing tools.
    Test {
        /// Runs only the steps whose names contain one of these words.
        steps: Vec<String>,
    },
    /// Runs the checks of docs/trust.md, which take hours.
    Prove {
        /// Runs only the checks whose names contain one of these words.
        checks: Vec<String>,
    },
    /// Draws a scene on the OLED of the LM3S6965 board in QEMU.
    Qemu {
        /// Scene file. If missing, the firmware draws its own scenes.
        #[arg(value_parser = existing)]
        scene: Option<PathBuf>,
        /// Writes a screenshot to this PNG or PPM file.
        #[arg(long, value_parser = absolute, conflicts_with = "window")]
        shot: Option<PathBuf>,
        /// Shows the display in a window. Arrow keys move the camera, left Ctrl selects the next
        /// scene.
        #[arg(long)]
        window: bool,
    },
    /// Draws a scene on a core in QEMU, without a display, and prints the number of instructions.
    Headless {
        #[command(flatten)]
        job: Job,
        /// Size of the picture, WIDTHxHEIGHT.
        #[arg(long, default_value = "320x240")]
        size: String,
        /// Draws with floating-point numbers, for comparison.
        #[arg(long)]
        float: bool,
    },
    /// Draws pictures in QEMU, counts the instructions, and writes docs/benchmarks.md.
    Bench(Bench),
    /// Fits the cost model of `cargo sim render --stats` and writes sim/src/cost/prices.rs.
    Fit,
    /// Draws a scene and prints the functions and lines that take the most instructions.
    Profile {
        #[command(flatten)]
        job: Job,
        /// Size of the picture, WIDTHxHEIGHT. Choose a small size, because QEMU logs every
        /// instruction.
        #[arg(long, default_value = "40x30")]
        size: String,
    },
    /// Tests the Raspberry Pi Pico's firmware in the emulator rp2040js.
    Pico {
        /// Scene file. If missing, runs the whole test of the board.
        #[arg(value_parser = existing)]
        scene: Option<PathBuf>,
        /// Writes a screenshot of the scene to this PNG file.
        #[arg(long, value_parser = absolute, requires = "scene")]
        shot: Option<PathBuf>,
        /// Stores the counted cycles as the budget.
        #[arg(long, conflicts_with = "scene")]
        bless: bool,
    },
    /// Builds the Raspberry Pi Pico's firmware as a UF2 file.
    Uf2 {
        /// Scene files. If missing, the firmware has its own scenes.
        #[arg(value_parser = existing)]
        scenes: Vec<PathBuf>,
    },
    /// Builds the firmware of all boards and compares the flash sizes with the budgets.
    Boards,
    /// Prints flash and RAM of the LM3S6965 and headless firmware.
    Size,
    /// Checks rules of the source code, such as the layers of the library.
    Tidy,
}

#[derive(Args)]
struct Job {
    /// Scene file.
    #[arg(value_parser = existing)]
    scene: PathBuf,
    /// Core that draws.
    #[arg(long, value_enum, default_value_t = Core::M3)]
    core: Core,
}

#[derive(Args)]
#[group(multiple = false)]
struct Bench {
    /// Draws only this scene of the benchmark and prints its table.
    #[arg(long)]
    scene: Option<String>,
    /// Fails if a picture takes more instructions than its budget.
    #[arg(long)]
    check: bool,
    /// Stores the counted instructions as the budget.
    #[arg(long)]
    bless: bool,
    /// Measures the flash of the choices in docs/flash.md and writes that page.
    #[arg(long)]
    flash: bool,
}

fn main() -> ExitCode {
    match run(Cli::parse().task) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn run(task: Task) -> Result<()> {
    match task {
        Task::Test { steps } => test::run(&steps),
        Task::Prove { checks } => prove::run(&checks),
        Task::Qemu {
            scene,
            shot,
            window,
        } => oled::run(scene.as_deref(), shot.as_deref(), window),
        Task::Headless { job, size, float } => headless(&job, &size, float),
        Task::Bench(Bench { check: true, .. }) => bench::check(),
        Task::Bench(Bench { bless: true, .. }) => bench::bless(),
        Task::Bench(Bench { flash: true, .. }) => bench::write_choices(),
        Task::Bench(Bench {
            scene: Some(scene), ..
        }) => bench::print(&scene),
        Task::Bench(_) => bench::write(),
        Task::Fit => fit::run(),
        Task::Profile { job, size } => profile::run(&job.scene, job.core, &size),
        Task::Pico {
            scene: Some(scene),
            shot,
            ..
        } => pico::draw(&scene, shot.as_deref()),
        Task::Pico { bless: true, .. } => pico::bless(),
        Task::Pico { .. } => pico::check(),
        Task::Uf2 { scenes } => pico::uf2(&scenes),
        Task::Boards => board::build_all(),
        Task::Size => size::print(),
        Task::Tidy => tidy::run(),
    }
}

fn headless(job: &Job, size: &str, float: bool) -> Result<()> {
    let arithmetic = if float {
        Arithmetic::Float
    } else {
        Arithmetic::Fixed
    };
    let machine = Machine::of(job.core);
    let elf = machine.rig(arithmetic.rig()).build(None)?;
    let report = machine.draw(&elf, &arithmetic.compile(&job.scene)?, size)?;
    print!("{report}");
    report.result().map(drop)
}

/// Returns the absolute path of an existing file. The user's path may be relative to the user's
/// working folder, but tasks run in the root of the project.
fn existing(path: &str) -> std::io::Result<PathBuf> {
    std::fs::canonicalize(path)
}

fn absolute(path: &str) -> std::io::Result<PathBuf> {
    std::path::absolute(path)
}
