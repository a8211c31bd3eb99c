//! Decodes a compiled scene and draws it for a display that expects sRGB.

#![no_std]
#![no_main]

use core::hint::black_box;

use choices::{Buffer, compiled, display, size};
use cortex_m_rt::entry;
use whitted::Renderer;
use whitted::render::{Output, Transfer};

#[entry]
fn main() -> ! {
    if let Ok(scene) = Buffer::new().decode(compiled()) {
        let mut renderer = Renderer::new(black_box(&scene), size());
        renderer.set_output(black_box(Output {
            transfer: Transfer::Srgb,
            ..Output::default()
        }));
        let Ok(()) = renderer.draw(&mut display());
    }
    loop {
        core::hint::spin_loop();
    }
}
