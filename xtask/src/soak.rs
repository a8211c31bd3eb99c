//! Frame after frame in QEMU, each compared with this machine's.

use anyhow::{Context, Result, ensure};
use embedded_graphics_core::prelude::Size;
use whitted::SceneBuffer;
use whitted::animation::AnimatedScene;
use whitted_sim::render;

use crate::qemu::{Core, Machine};

#[path = "../../tests/rigs/soak/src/frames.rs"]
mod frames;
#[path = "../../tests/rigs/motion/src/scene.rs"]
#[allow(dead_code, reason = "its times and size are those of other firmware")]
mod scene;

/// In no frame after so many may the stack be deeper than in those before: one loop of
/// the animation.
const SETTLED: u16 = 54;

/// Draws so many frames on a core. Returns the bytes of stack at the deepest.
pub fn soak(core: Core, frames: u16) -> Result<u32> {
    let machine = Machine::of(core);
    let firmware = machine.start(&machine.soak().build(None)?)?;
    let mut host = Host::default();
    let mut settled = 0;
    for frame in 0..frames {
        let line = firmware.line()?;
        let expected = format!("{frame}: {:08x} ", host.checksum(frame)?);
        let stack = line.strip_prefix(&expected);
        let stack = stack.with_context(|| format!("{core} draws {line:?}, not {expected:?}"))?;
        let stack = stack.parse()?;
        if frame < SETTLED {
            settled = stack;
        }
        if frame % 1000 == 999 {
            println!("{}: {} frames", core.title(), frame + 1);
        }
        ensure!(
            stack == settled,
            "the stack on {core} has grown from {settled} to {stack} bytes at frame {frame}"
        );
    }
    Ok(settled)
}

/// Draws the same frames here.
#[derive(Default)]
struct Host {
    stage: Box<AnimatedScene<5, 1>>,
    buffer: Box<SceneBuffer<5, 1, 5>>,
}

impl Host {
    fn checksum(&mut self, frame: u16) -> Result<u32> {
        let time = frames::time(frame);
        let moved = self.stage.frame(&scene::SCENE, &scene::ANIMATION, time)?;
        let [width, height] = frames::SIZE;
        let picture = render::linear(&self.buffer.prepare(&moved)?, Size::new(width, height));
        Ok(render::checksum(&picture))
    }
}
