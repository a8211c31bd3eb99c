//! Decodes a compiled scene and moves its camera.

#![no_std]
#![no_main]

use choices::{Buffer, compiled, draw, number};
use cortex_m_rt::entry;

#[entry]
fn main() -> ! {
    if let Ok(mut scene) = Buffer::new().decode(compiled()) {
        let camera = scene.camera().orbited(number(), number());
        if scene.set_camera(&camera).is_ok() {
            draw(&scene);
        }
    }
    loop {
        core::hint::spin_loop();
    }
}
