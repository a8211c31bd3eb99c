//! Decodes a compiled scene and draws it in steps of limited work.

#![no_std]
#![no_main]

use core::hint::black_box;

use choices::{Buffer, compiled, display, size};
use cortex_m_rt::entry;
use embedded_graphics_core::prelude::*;
use whitted::Renderer;
use whitted::render::{RenderProgress, Step};

#[entry]
fn main() -> ! {
    if let Ok(scene) = Buffer::new().decode(compiled()) {
        let (mut display, mut renderer) = (display(), Renderer::new(black_box(&scene), size()));
        let mut progress = RenderProgress::progressive(display.bounding_box());
        while !progress.is_complete() {
            let Ok(()) = renderer.step(&mut progress, Step::Rays(black_box(800)), &mut display);
        }
    }
    loop {
        core::hint::spin_loop();
    }
}
