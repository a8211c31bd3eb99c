//! Draws animation frames in an endless loop. For each frame, prints the frame number, the
//! checksum, and the deepest stack usage so far in bytes.

#![no_std]
#![no_main]

mod frames;
#[path = "../../motion/src/scene.rs"]
#[allow(dead_code, reason = "the times and size are for the motion rig")]
mod scene;

use core::panic::PanicInfo;

use cortex_m_rt::entry;
use embedded_graphics_core::prelude::Size;
use frames::{SIZE, time};
use measure::{Checksum, peak_stack};
use scene::{ANIMATION, SCENE};
use whitted::animation::PreparedAnimation;
use whitted::{Renderer, SceneBuffer};

#[entry]
fn main() -> ! {
    static mut BUFFER: SceneBuffer<5, 1, 5> = SceneBuffer::new();

    let Ok(mut animation) = BUFFER.prepare_animation(&SCENE, &ANIMATION) else {
        mps2::print("error: the animation cannot be prepared\n");
        mps2::exit();
    };
    let mut frame = 0;
    loop {
        match draw(frame, &mut animation) {
            Some(checksum) => {
                mps2::print(format_args!("{frame}: {checksum:08x} {}\n", peak_stack()))
            }
            None => mps2::print("error: the camera has no direction\n"),
        }
        frame = frame.wrapping_add(1);
    }
}

/// Draws a frame and returns its checksum, or `None` if its camera has no direction.
fn draw(frame: u16, animation: &mut PreparedAnimation<'_>) -> Option<u32> {
    let prepared = animation.frame(time(frame)).ok()?;
    let mut renderer = Renderer::new(&prepared, Size::new(SIZE[0], SIZE[1]));
    let mut checksum = Checksum::default();
    (0..SIZE[1]).find_map(|_| checksum.line(&mut renderer))
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    mps2::print(format_args!("error: {info}\n"));
    mps2::exit();
}
