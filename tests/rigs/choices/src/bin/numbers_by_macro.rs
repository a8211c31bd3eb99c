//! Prepares a scene in a loop that contains the macro `real!`.

#![no_std]
#![no_main]

use choices::{SCENE, number, prepare_and_draw};
use cortex_m_rt::entry;
use whitted::{Scene, real};

#[entry]
fn main() -> ! {
    let mut scene: Scene<'static> = SCENE;
    loop {
        scene.camera.eye.x += number() + real!(0.25);
        prepare_and_draw(&scene);
    }
}
