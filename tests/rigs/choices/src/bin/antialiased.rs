//! Decodes a compiled scene and draws it with smooth edges.

#![no_std]
#![no_main]

use core::hint::black_box;

use choices::{Buffer, compiled, display, size};
use cortex_m_rt::entry;
use whitted::render::{AaSample, AntialiasedRenderer, SampleCount};

#[entry]
fn main() -> ! {
    let mut memory = [AaSample::BLACK; 2 * 240];
    if let Ok(scene) = Buffer::new().decode(compiled())
        && let Ok(mut renderer) =
            AntialiasedRenderer::new(black_box(&scene), size(), SampleCount::Four, &mut memory)
    {
        let Ok(()) = renderer.draw(&mut display());
    }
    loop {
        core::hint::spin_loop();
    }
}
