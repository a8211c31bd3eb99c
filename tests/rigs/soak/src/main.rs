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
use whitted::animation::AnimatedScene;
use whitted::{Renderer, SceneBuffer};

#[entry]
fn main() -> ! {
    static mut BUFFER: SceneBuffer<5, 1, 5> = SceneBuffer::new();
    static mut ANIMATED: AnimatedScene<5, 1> = AnimatedScene::new();

    let mut frame = 0;
    loop {
        match draw(frame, ANIMATED, BUFFER) {
            Some(checksum) => {
                mps2::print(format_args!("{frame}: {checksum:08x} {}\n", peak_stack()))
            }
            None => mps2::print("error: the scene cannot be prepared\n"),
        }
        frame = frame.wrapping_add(1);
    }
}

/// Draws a frame and returns its checksum, or `None` if the scene cannot be prepared.
fn draw(
    frame: u16,
    animated: &mut AnimatedScene<5, 1>,
    buffer: &mut SceneBuffer<5, 1, 5>,
) -> Option<u32> {
    let moved = animated.frame(&SCENE, &ANIMATION, time(frame)).ok()?;
    let prepared = buffer.prepare(&moved).ok()?;
    let mut renderer = Renderer::new(&prepared, Size::new(SIZE[0], SIZE[1]));
    let mut checksum = Checksum::default();
    (0..SIZE[1]).find_map(|_| checksum.line(&mut renderer))
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    mps2::print(format_args!("error: {info}\n"));
    mps2::exit();
}
