//! Tests the transfer of scenes over USB.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use scene_serial::{frame, frame_len};
use whitted::{Camera, Material, MaterialId, Object, Real, Scene, SceneBuffer, real, vec3};
use whitted_sim::scene_file;

use super::port::Port;
use crate::command::{cargo, command, run};
use crate::host::decode_error;
use crate::target_dir;

/// Number that identifies a transfer. The board repeats this number in its answer.
const TICKET: u16 = 7;

/// Sends data that the board must reject, and checks the answers of the board.
pub(super) fn send_invalid(port: &Port, scene: &Path) -> Result<()> {
    let compiled = scene_file::compile(scene)?;
    let whole = framed(&compiled)?;
    let half = whole[..whole.len() / 2].to_vec();
    let mut flipped = whole.clone();
    flipped[half.len()] ^= 1;
    let mut newer = compiled;
    newer[4] += 1;
    let damaged = "broken: data damaged in transit";
    let cut = "broken: transfer stopped before the end";
    let too_long = "broken: scene exceeds the limit of 16378 bytes";
    let rejected = |scene: &[u8]| anyhow::Ok(format!("refused 0007: {}", decode_error(scene)?));
    let large = too_many_spheres()?;
    for (bytes, expected) in [
        (b"AT+GMI\r\n\0".to_vec(), damaged.to_owned()),
        (flipped, damaged.to_owned()),
        (half, cut.to_owned()),
        (framed(&[1; 20_000])?, too_long.to_owned()),
        (framed(&newer)?, rejected(&newer)?),
        (framed(&large)?, rejected(&large)?),
    ] {
        let answer = port.request(&bytes)?;
        ensure!(
            answer == expected,
            "answer {answer:?}, expected {expected:?}"
        );
    }
    Ok(())
}

/// Builds the program `sim` with the same features as other tests, and returns its path.
pub(super) fn build_sim() -> Result<PathBuf> {
    let mut build = cargo();
    build.args(["build", "--quiet", "--bin", "sim"]);
    // All steps of `cargo xtask test` build with this feature, so that they share one build.
    run(build.args(["--features", "whitted-sim/window"]))?;
    Ok(target_dir().join("debug/sim"))
}

/// Sends a scene with the command `sim send`.
pub(super) fn send(program: &Path, port: &Port, scene: &Path) -> Result<()> {
    let mut sim = command(program);
    sim.arg("send").arg(scene).arg("--port").arg(port.path());
    let output = sim.output()?;
    let text = String::from_utf8_lossy(&output.stdout);
    let errors = String::from_utf8_lossy(&output.stderr);
    ensure!(output.status.success(), "`sim send` failed: {errors}");
    ensure!(text.ends_with(": shown\n"), "`sim send` prints {text:?}");
    Ok(())
}

fn framed(scene: &[u8]) -> Result<Vec<u8>> {
    let mut buffer = vec![0; frame_len(scene.len())];
    let frame = frame(TICKET, scene, &mut buffer).context("the frame does not fit")?;
    Ok(frame.to_vec())
}

/// Returns a compiled scene with one sphere more than the firmware can store.
fn too_many_spheres() -> Result<Vec<u8>> {
    let origin = vec3!(0, 0, 0);
    let objects = [Object::sphere(origin, Real::ONE, MaterialId(0)); 65];
    let camera = Camera::new(vec3!(0, 2, 8), origin, real!(33));
    let mut buffer = Box::new(SceneBuffer::<65, 1, 1>::new());
    let scene = buffer.prepare(&Scene {
        materials: &[Material::BLACK],
        objects: &objects,
        ..Scene::new(camera)
    })?;
    let mut bytes = vec![0; scene.encoded_len()];
    scene.encode(&mut bytes).context("the scene does not fit")?;
    Ok(bytes)
}
