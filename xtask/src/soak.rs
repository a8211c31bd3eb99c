//! Draws long animations in QEMU and compares each frame with the same frame drawn on the host.

use anyhow::{Context, Result, ensure};
use embedded_graphics_core::prelude::Size;
use whitted::SceneBuffer;
use whitted::animation::PreparedAnimation;
use whitted_sim::render;

use crate::core::Core;
use crate::qemu::Machine;

#[path = "../../tests/rigs/soak/src/frames.rs"]
mod frames;
#[path = "../../tests/rigs/motion/src/scene.rs"]
#[allow(dead_code, reason = "times and size are for other firmware")]
mod scene;

/// Number of frames in one loop of the animation. The stack must not grow after the first loop.
const LOOP: u16 = 54;

/// Draws frames on a core in QEMU and on the host, and compares the checksums. Returns the peak
/// stack size on the core in bytes.
pub fn soak(core: Core, frames: u16) -> Result<u32> {
    let machine = Machine::of(core);
    let firmware = machine.start(&machine.rig("soak").build(None)?)?;
    let mut buffer = Box::new(SceneBuffer::<5, 1, 5>::new());
    let mut animation = buffer.prepare_animation(&scene::SCENE, &scene::ANIMATION)?;
    let mut peak = 0;
    for frame in 0..frames {
        let line = firmware.line()?;
        let expected = format!("{frame}: {:08x} ", checksum(&mut animation, frame)?);
        let stack = line
            .strip_prefix(&expected)
            .with_context(|| format!("{core} prints {line:?}, expected {expected:?}"))?
            .parse()?;
        if frame < LOOP {
            peak = stack;
        }
        ensure!(
            stack == peak,
            "the stack on {core} grows from {peak} to {stack} bytes at frame {frame}"
        );
    }
    Ok(peak)
}

/// Draws a frame on the host.
fn checksum(animation: &mut PreparedAnimation<'_>, frame: u16) -> Result<u32> {
    let [width, height] = frames::SIZE;
    let scene = animation.frame(frames::time(frame))?;
    Ok(render::checksum(&render::linear(
        &scene,
        Size::new(width, height),
    )))
}
