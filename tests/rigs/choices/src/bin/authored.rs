//! Prepares a scene that is written in code.

#![no_std]
#![no_main]

use choices::{SCENE, prepare_and_draw};
use cortex_m_rt::entry;

#[entry]
fn main() -> ! {
    prepare_and_draw(&SCENE);
    loop {
        core::hint::spin_loop();
    }
}
