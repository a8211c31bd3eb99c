//! Animates a scene that is written in code.

#![no_std]
#![no_main]

use core::hint::black_box;

use choices::{SCENE, number, prepare_and_draw};
use cortex_m_rt::entry;
use whitted::animation::{AnimatedScene, Animation};
use whitted::real;

static ANIMATION: Animation = Animation {
    duration: real!(2),
    looping: true,
    tracks: &[],
};

#[entry]
fn main() -> ! {
    let mut animated = AnimatedScene::<8, 2>::new();
    if let Ok(scene) = animated.frame(black_box(&SCENE), black_box(&ANIMATION), number()) {
        prepare_and_draw(&scene);
    }
    loop {}
}
