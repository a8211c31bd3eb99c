//! Draws all scenes on all targets and compares the checksums with those of the host.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use embedded_graphics_core::geometry::Size;

use crate::board::RISCV;
use crate::command::{cargo, command, run};
use crate::firmware::PROFILE;
use crate::qemu::Arithmetic;
use crate::tools::require;
use crate::{host, root, scenes, target_dir};

const WASM: &str = "wasm32-unknown-unknown";

const SIZE: Size = Size::new(80, 60);

/// A compiled scene and the checksum of its picture on the host.
struct Picture {
    name: String,
    compiled: PathBuf,
    checksum: String,
}

pub(super) fn check() -> Result<()> {
    let mut cortex_m = cargo();
    cortex_m.args(["test", "--package", "xtask", "--test", "qemu"]);
    run(cortex_m.arg("all_cores_draw_the_same"))?;
    let pictures: Result<Vec<_>> = scenes()?.iter().map(|scene| draw_on_host(scene)).collect();
    let pictures = pictures?;
    risc_v(&pictures)?;
    wasm(&pictures)
}

fn draw_on_host(scene: &Path) -> Result<Picture> {
    Ok(Picture {
        name: scene.file_stem().unwrap_or_default().display().to_string(),
        compiled: Arithmetic::Fixed.compile(scene)?,
        checksum: host::checksum(scene, SIZE)?,
    })
}

impl Picture {
    fn compare(&self, checksum: &str, target: &str) -> Result<()> {
        let Self { name, .. } = self;
        ensure!(checksum == self.checksum, "{name} differs on {target}");
        Ok(())
    }
}

/// Draws all scenes on a RISC-V core in QEMU. QEMU writes the picture size, the length of the
/// compiled scene, and the compiled scene to the memory of the firmware `tests/rigs/virt`.
fn risc_v(pictures: &[Picture]) -> Result<()> {
    const QEMU: &str = "qemu-system-riscv32";
    require(&[QEMU], "sudo apt-get install qemu-system-misc")?;
    let mut build = cargo();
    // Cargo reads its configuration from the working folder.
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
        let words = [SIZE.width.into(), SIZE.height.into(), length];
        for (word, address) in words.into_iter().zip((0x8100_0000_u64..).step_by(4)) {
            qemu.arg("-device");
            qemu.arg(format!("loader,addr={address:#x},data={word},data-len=4"));
        }
        let file = picture.compiled.display().to_string().replace(',', ",,");
        qemu.arg("-device");
        qemu.arg(format!("loader,addr=0x81001000,file={file},force-raw=on"));
        let output = qemu.output().context(QEMU)?;
        let text = String::from_utf8_lossy(&output.stdout);
        let checksum = text.trim().strip_prefix("checksum: ");
        let checksum = checksum.with_context(|| format!("{QEMU} prints {text:?}"))?;
        picture.compare(checksum, RISCV)?;
    }
    println!("{RISCV}: {} equal pictures", pictures.len());
    Ok(())
}

fn wasm(pictures: &[Picture]) -> Result<()> {
    require(&["node"], "sudo apt-get install nodejs")?;
    let mut build = cargo();
    build.args(["build", "--quiet", "--profile", PROFILE]);
    run(build.args(["--package", "wasm", "--target", WASM]))?;
    let mut node = command("node");
    node.arg("tests/rigs/wasm/checksum.mjs");
    node.arg(target_dir().join(WASM).join(PROFILE).join("wasm.wasm"));
    node.args([SIZE.width.to_string(), SIZE.height.to_string()]);
    node.args(pictures.iter().map(|picture| &picture.compiled));
    let output = node.output()?;
    let text = String::from_utf8(output.stdout)?;
    let errors = String::from_utf8_lossy(&output.stderr);
    ensure!(text.lines().count() == pictures.len(), "node: {errors}");
    for (picture, checksum) in pictures.iter().zip(text.lines()) {
        picture.compare(checksum, WASM)?;
    }
    println!("{WASM}: {} equal pictures", pictures.len());
    Ok(())
}
