//! Decodes a compiled scene.

#![no_std]
#![no_main]

use choices::{Buffer, compiled, draw};
use cortex_m_rt::entry;

#[entry]
fn main() -> ! {
    if let Ok(scene) = Buffer::new().decode(compiled()) {
        draw(&scene);
    }
    loop {
        core::hint::spin_loop();
    }
}
