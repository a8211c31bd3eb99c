//! Does what `numbers_by_macro` does, without the macro.

#![no_std]
#![no_main]

use choices::{SCENE, number, prepare_and_draw};
use cortex_m_rt::entry;
use whitted::{Real, Scene};

#[entry]
fn main() -> ! {
    let mut scene: Scene<'static> = SCENE;
    loop {
        scene.camera.eye.x += number() + Real::from_bits(1 << 30);
        prepare_and_draw(&scene);
    }
}
