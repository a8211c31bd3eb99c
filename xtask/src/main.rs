//! `cargo xtask`: runs one of the project's tasks.

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{Result, bail};
use lexopt::prelude::*;
use xtask::qemu::{Arithmetic, Core, Machine};
use xtask::{bench, board, firmware, model, oled, pico, povray, profile, prove, size, test, tidy};

const HELP: &str = "\
cargo xtask TASK

  test [STEP...]        All checks and tests, or the steps whose names contain one
                        of these words. Installs the tools that are missing.
  prove [PROMISE...]    What firmware relies on, proven as far as can be; or the promises
                        whose names contain one of these words. Writes docs/trust.md.
  qemu [SCENE] [--shot FILE.png] [--window]
                        Draws a scene on the OLED of the LM3S6965 board, in QEMU;
                        takes a screenshot, or shows the display in a window, where
                        arrow keys move the camera and left Ctrl, unless there is
                        but one, shows the next scene.
  headless SCENE [--size WxH] [--core m0|m3|m4f|m7|m33] [--float]
                        Draws a scene on a core, in QEMU, and prints what it took;
                        in floating point for comparison.
  bench [--scene NAME] [--core CORE] [--json FILE]
                        Counts the instructions of pictures on all cores, next to
                        those in floating point; writes docs/benchmarks.md.
  bench --growth        Only how they grow with the spheres in view.
  bench --check         Fails where a picture takes more than its budget.
  bench --bless         Makes what pictures take now the budget.
  fit                   Fits the cost model of `cargo sim render --stats` to what
                        pictures take; writes sim/cost.toml and docs/cost-model.md.
  profile SCENE [--core CORE] [--size WxH]
                        Where the instructions of a frame go, by function and line.
  pico [SCENE] [--shot FILE.png]
                        Draws a scene with the firmware of the Raspberry Pi Pico, in
                        rp2040js, and says its cycles; without one, does all that can be
                        done with it, scenes over USB included, compares pictures with
                        the host's, and cycles with the budget.
  pico --bless          Makes what pictures take now the budget.
  uf2 [SCENE...]        Builds that firmware, to be dropped on a Pico in boot mode.
  povray [--depth N]    Times POV-Ray, where it is installed, and `cargo sim render` on
                        the sphereflake of this depth; 6 unless told.
  boards                Builds the firmware of all boards with displays and fails where
                        one takes more flash than its budget.
  size                  Flash and RAM of each firmware.
  tidy                  Checks the rules of the source code.
";

fn main() -> ExitCode {
    match task() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn task() -> Result<()> {
    let mut arguments = lexopt::Parser::from_env();
    let task = match arguments.next()? {
        Some(Value(task)) => task.string()?,
        _ => String::new(),
    };
    let options = Options::parse(&mut arguments)?;
    match task.as_str() {
        "test" => test::run(&options.values),
        "prove" => prove::run(&options.values),
        "qemu" => on_the_oled(&options),
        "headless" => headless(&options),
        "bench" => bench(&options),
        "fit" => model::run(),
        "profile" => profile(&options),
        "pico" => pico(&options),
        "uf2" => pico::uf2(&options.scenes()?),
        "povray" => povray::run(options.depth),
        "boards" => board::build_all(),
        "size" => size::print(),
        "tidy" => tidy::run(),
        _ => {
            print!("{HELP}");
            Ok(())
        }
    }
}

fn on_the_oled(options: &Options) -> Result<()> {
    let elf = firmware::LM3S6965EVB.build(options.scene()?.as_deref())?;
    if options.window {
        return oled::show(&elf);
    }
    let report = oled::draw(&elf, options.shot.as_deref())?;
    print!("{report}");
    report.result().map(drop)
}

fn headless(options: &Options) -> Result<()> {
    let Some(scene) = options.scene()? else {
        bail!("headless takes a scene");
    };
    let machine = Machine::of(options.core.unwrap_or(Core::M3));
    let elf = machine.firmware(options.arithmetic).build(None)?;
    let size = options.size.as_deref().unwrap_or("320x240");
    let compiled = options.arithmetic.compile(&scene)?;
    let report = machine.draw(&elf, &compiled, size)?;
    print!("{report}");
    report.result().map(drop)
}

fn pico(options: &Options) -> Result<()> {
    match options.scene()? {
        Some(scene) => pico::draw(&scene, options.shot.as_deref()),
        None if options.bless => pico::bless(),
        None => pico::check(),
    }
}

fn bench(options: &Options) -> Result<()> {
    if options.growth {
        return bench::growth();
    }
    match (options.check, options.bless) {
        (_, true) => bench::bless(),
        (true, false) => bench::check(),
        (false, false) => bench::run(
            options.only_scene.as_deref(),
            options.core,
            options.json.as_deref(),
        ),
    }
}

fn profile(options: &Options) -> Result<()> {
    let Some(scene) = options.scene()? else {
        bail!("profile takes a scene");
    };
    // Every instruction is logged.
    let size = options.size.as_deref().unwrap_or("40x30");
    profile::run(&scene, options.core.unwrap_or(Core::M3), size)
}

struct Options {
    values: Vec<String>,
    shot: Option<PathBuf>,
    window: bool,
    size: Option<String>,
    core: Option<Core>,
    json: Option<PathBuf>,
    only_scene: Option<String>,
    check: bool,
    bless: bool,
    growth: bool,
    depth: u32,
    arithmetic: Arithmetic,
}

impl Options {
    fn parse(arguments: &mut lexopt::Parser) -> Result<Self> {
        let mut options = Self {
            values: Vec::new(),
            shot: None,
            window: false,
            size: None,
            core: None,
            json: None,
            only_scene: None,
            check: false,
            bless: false,
            growth: false,
            depth: 6,
            arithmetic: Arithmetic::Fixed,
        };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("shot") => options.shot = Some(std::path::absolute(arguments.value()?)?),
                Long("window") => options.window = true,
                Long("size") => options.size = Some(arguments.value()?.string()?),
                Long("core") => options.core = Some(arguments.value()?.parse()?),
                Long("json") => options.json = Some(std::path::absolute(arguments.value()?)?),
                Long("scene") => options.only_scene = Some(arguments.value()?.string()?),
                Long("check") => options.check = true,
                Long("bless") => options.bless = true,
                Long("depth") => options.depth = arguments.value()?.parse()?,
                Long("growth") => options.growth = true,
                Long("float") => options.arithmetic = Arithmetic::Float,
                Value(value) => options.values.push(value.string()?),
                other => return Err(other.unexpected().into()),
            }
        }
        Ok(options)
    }

    /// The scene.
    fn scene(&self) -> Result<Option<PathBuf>> {
        if let [_, other, ..] = self.values.as_slice() {
            bail!("one scene at a time, not {other} too");
        }
        Ok(self.scenes()?.pop())
    }

    /// The scenes, which are named relative to where the person is.
    fn scenes(&self) -> Result<Vec<PathBuf>> {
        let found = |scene: &String| {
            std::fs::canonicalize(scene).map_err(|error| anyhow::anyhow!("{scene}: {error}"))
        };
        self.values.iter().map(found).collect()
    }
}
