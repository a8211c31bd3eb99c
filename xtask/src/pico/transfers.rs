//! Scenes over USB: some that do not arrive, and one that does.

use std::iter;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use scene_serial::{frame, frame_len};
use whitted::{Camera, Material, MaterialId, Object, Real, Scene, SceneBuffer, Vec3};
use whitted_sim::scene_file;

use super::port::Port;
use crate::command::{cargo, command, run};
use crate::target_dir;
use crate::test::WINDOW;

const TICKET: u16 = 7;

/// Sends what the board must not take, a scene in all these ways; each has its answer.
pub(super) fn break_off(port: &Port, scene: &Path) -> Result<()> {
    let compiled = scene_file::compile(scene)?;
    let whole = framed(&compiled)?;
    let half = whole[..whole.len() / 2].to_vec();
    let mut flipped = whole.clone();
    flipped[half.len()] ^= 1;
    let mut newer = compiled;
    newer[4] += 1;
    let garbage = b"AT+GMI\r\n\0".to_vec();
    for (bytes, expected) in [
        (garbage, "broken: data damaged in transit"),
        (flipped, "broken: data damaged in transit"),
        (half, "broken: transfer stopped before the end"),
        (
            framed(&[1; 20_000])?,
            "broken: scene exceeds the limit of 16378 bytes",
        ),
        (
            framed(&newer)?,
            "refused 0007: unsupported format version 4, expected 3: recompile the scene",
        ),
        (
            framed(&crowd()?)?,
            "refused 0007: too many objects: the buffer holds 64",
        ),
    ] {
        let answer = port.ask(&bytes)?;
        ensure!(answer == expected, "{answer:?} in place of {expected:?}");
    }
    Ok(())
}

/// The program that persons send scenes by, as the tests build it.
pub(super) fn program() -> Result<PathBuf> {
    run(cargo()
        .args(["build", "--quiet", "--bin", "sim"])
        .args(WINDOW))?;
    Ok(target_dir().join("debug/sim"))
}

/// Sends a scene by it.
pub(super) fn send(program: &Path, port: &Port, scene: &Path) -> Result<()> {
    let mut sim = command(program);
    sim.arg("send").arg(scene).arg("--port").arg(port.path());
    let output = sim.output()?;
    let (said, errors) = (
        String::from_utf8_lossy(&output.stdout),
        String::from_utf8_lossy(&output.stderr),
    );
    ensure!(output.status.success(), "`sim send` failed: {errors}");
    ensure!(said.ends_with(": shown\n"), "`sim send` says {said:?}");
    Ok(())
}

fn framed(scene: &[u8]) -> Result<Vec<u8>> {
    let mut room = vec![0; frame_len(scene.len())];
    let frame = frame(TICKET, scene, &mut room).context("there is room")?;
    Ok(frame.to_vec())
}

/// A scene of one sphere more than the firmware has room for.
fn crowd() -> Result<Vec<u8>> {
    let spheres: Vec<_> = iter::repeat_n(Vec3::lit("0", "0", "0"), 65)
        .map(|center| Object::sphere(center, Real::ONE, MaterialId(0)))
        .collect();
    let camera = Camera::new(
        Vec3::lit("0", "2", "8"),
        Vec3::lit("0", "1", "0"),
        Real::lit("33"),
    );
    let mut buffer = Box::new(SceneBuffer::<65, 1, 1>::new());
    let scene = buffer.prepare(&Scene {
        materials: &[Material::BLACK],
        objects: &spheres,
        ..Scene::new(camera)
    })?;
    let mut bytes = vec![0; scene.encoded_len()];
    scene.encode(&mut bytes).context("there is room")?;
    Ok(bytes)
}
