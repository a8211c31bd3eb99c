//! The same bits on every target.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use embedded_graphics_core::geometry::Size;
use whitted_sim::{render, scene_file};

use super::tools::{self, MIPS, NIGHTLY, RISCV, WASM};
use crate::command::{cargo, command, run};
use crate::firmware::PROFILE;
use crate::qemu::{Arithmetic, Core, Machine};
use crate::{root, scenes, target_dir};

const SIZE: Size = Size::new(80, 60);

/// A scene, compiled, and the checksum of its picture on this machine.
struct Picture {
    name: String,
    compiled: PathBuf,
    checksum: String,
}

pub(super) fn prove() -> Result<String> {
    let pictures = pictures()?;
    cortex_m(&pictures)?;
    risc_v(&pictures)?;
    wasm(&pictures)?;
    for target in [None, Some(MIPS)] {
        miri(target)?;
    }
    Ok(format!(
        "{} scenes alike on the host, {} Cortex-M cores, riscv32imc and wasm32; one of them, and the library's own tests, in Miri on the host and as on {MIPS}",
        pictures.len(),
        Core::ALL.len()
    ))
}

fn pictures() -> Result<Vec<Picture>> {
    scenes()?.iter().map(|scene| picture(scene)).collect()
}

fn picture(scene: &Path) -> Result<Picture> {
    let file = scene_file::load(scene)?;
    let mut buffer = Box::new(scene_file::Buffer::new());
    let drawn = render::linear(&file.prepare(&mut buffer)?, SIZE);
    Ok(Picture {
        name: scene.file_stem().unwrap_or_default().display().to_string(),
        compiled: Arithmetic::Fixed.compile(scene)?,
        checksum: format!("{:08x}", render::checksum(&drawn)),
    })
}

impl Picture {
    fn is(&self, checksum: &str, on: &str) -> Result<()> {
        let Self { name, .. } = self;
        ensure!(checksum == self.checksum, "{name} differs on {on}");
        Ok(())
    }
}

fn cortex_m(pictures: &[Picture]) -> Result<()> {
    let size = format!("{}x{}", SIZE.width, SIZE.height);
    for core in Core::ALL {
        let machine = Machine::of(core);
        let elf = machine.firmware(Arithmetic::Fixed).build(None)?;
        for picture in pictures {
            let report = machine.draw(&elf, &picture.compiled, &size)?;
            picture.is(report.result()?.get("checksum")?, core.title())?;
        }
        println!("{}: all alike", core.title());
    }
    Ok(())
}

fn risc_v(pictures: &[Picture]) -> Result<()> {
    const QEMU: &str = "qemu-system-riscv32";
    tools::target(RISCV)?;
    tools::program(QEMU, "sudo apt-get install qemu-system-misc")?;
    let mut build = cargo();
    // In its own folder, where its memory.x is.
    build.current_dir(root().join("tests/rigs/virt"));
    build.env("CARGO_TARGET_DIR", target_dir());
    run(build.args(["build", "--quiet", "--release", "--target", RISCV]))?;
    let elf = target_dir().join(RISCV).join("release/virt");
    for picture in pictures {
        let mut qemu = command(QEMU);
        qemu.args(["-machine", "virt", "-bios", "none", "-nodefaults"]);
        qemu.args(["-display", "none", "-serial", "stdio", "-kernel"])
            .arg(&elf);
        let length = fs::metadata(&picture.compiled)?.len();
        let job = [SIZE.width.into(), SIZE.height.into(), length];
        for (word, address) in job.into_iter().zip((0x8100_0000_u64..).step_by(4)) {
            qemu.arg("-device");
            qemu.arg(format!("loader,addr={address:#x},data={word},data-len=4"));
        }
        let file = picture.compiled.display().to_string().replace(',', ",,");
        qemu.arg("-device");
        qemu.arg(format!("loader,addr=0x81001000,file={file},force-raw=on"));
        let output = qemu.output().context(QEMU)?;
        let text = String::from_utf8_lossy(&output.stdout);
        let checksum = text.trim().strip_prefix("checksum: ");
        picture.is(
            checksum.with_context(|| format!("it prints {text:?}"))?,
            RISCV,
        )?;
    }
    println!("{RISCV}: all alike");
    Ok(())
}

fn wasm(pictures: &[Picture]) -> Result<()> {
    tools::target(WASM)?;
    tools::program("node", "see https://nodejs.org")?;
    let mut build = cargo();
    build.args(["build", "--quiet", "--profile", PROFILE]);
    run(build.args(["--package", "wasm", "--target", WASM]))?;
    let module = target_dir().join(WASM).join(PROFILE).join("wasm.wasm");
    let mut node = command("node");
    node.arg("tests/rigs/wasm/checksum.mjs").arg(module);
    node.args([SIZE.width.to_string(), SIZE.height.to_string()]);
    node.args(pictures.iter().map(|picture| &picture.compiled));
    let output = node.output()?;
    let text = String::from_utf8(output.stdout)?;
    ensure!(
        text.lines().count() == pictures.len(),
        "node: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    for (picture, checksum) in pictures.iter().zip(text.lines()) {
        picture.is(checksum, WASM)?;
    }
    println!("{WASM}: all alike");
    Ok(())
}

/// What takes Miri hours: errors are measured by many numbers.
const SLOW: [&str; 3] = ["budget", "sixteen_bits", "srgb_is_within"];

/// The library's own tests and one scene in Miri, which also sees to it that
/// memory is used as it should be.
fn miri(target: Option<&str>) -> Result<()> {
    tools::toolchain(
        NIGHTLY,
        "toolchain install nightly --component miri rust-src",
    )?;
    let mut miri = command("cargo");
    miri.args([NIGHTLY, "miri", "test", "--package", "whitted"]);
    miri.args(["--lib", "--test", "everywhere"]);
    if let Some(target) = target {
        miri.args(["--target", target]);
    }
    miri.arg("--");
    miri.args(SLOW.map(|test| format!("--skip={test}")));
    // By the files of its own, as toolchains do not share them.
    miri.env("CARGO_TARGET_DIR", target_dir().join("miri"));
    miri.env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO");
    run(&mut miri)
}
