//! Animates a scene that is written in code.

#![no_std]
#![no_main]

use core::hint::black_box;

use choices::{Buffer, SCENE, draw, number};
use cortex_m_rt::entry;
use whitted::animation::Animation;
use whitted::real;

static ANIMATION: Animation = Animation {
    duration: real!(2),
    looping: true,
    tracks: &[],
};

#[entry]
fn main() -> ! {
    let mut buffer = Buffer::new();
    let animation = buffer.prepare_animation(black_box(&SCENE), black_box(&ANIMATION));
    if let Ok(mut animation) = animation
        && let Ok(scene) = animation.frame(number())
    {
        draw(&scene);
    }
    loop {
        core::hint::spin_loop();
    }
}
