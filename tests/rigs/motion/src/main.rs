//! Draws frames of an animated scene that is stored in flash. Counts the instructions to prepare
//! the animation, and to compute each frame before it is drawn.

#![no_std]
#![no_main]

mod scene;

use core::panic::PanicInfo;

use cortex_m::peripheral::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics_core::prelude::Size;
use measure::Stopwatch;
use scene::{ANIMATION, SCENE, SIZE, TIMES};
use whitted::animation::PreparedAnimation;
use whitted::codec::Crc32;
use whitted::{Color, PreparedScene, Renderer, SceneBuffer};

const WIDTH: usize = SIZE[0] as usize;

#[entry]
fn main() -> ! {
    static mut BUFFER: SceneBuffer<5, 1, 5> = SceneBuffer::new();

    match Peripherals::take() {
        Some(core) => play(
            BUFFER,
            &mut Stopwatch::new(core.SYST, mps2::NANOSECONDS_PER_CLOCK),
        ),
        None => mps2::print("error: peripherals already taken\n"),
    }
    mps2::exit();
}

/// Prepares the animation, draws its frames, and prints the instructions that preparing takes.
fn play(buffer: &mut SceneBuffer<5, 1, 5>, stopwatch: &mut Stopwatch) {
    let before = lap(stopwatch);
    let mut animation = match buffer.prepare_animation(&SCENE, &ANIMATION) {
        Ok(animation) => animation,
        Err(error) => return mps2::print(format_args!("error: {error}\n")),
    };
    let preparing = lap(stopwatch) - before;
    mps2::print(format_args!("prepare: {preparing}\n"));
    for frame in 0..TIMES.len() {
        draw(frame, &mut animation, stopwatch);
    }
}

/// Returns the number of instructions since the start.
fn lap(stopwatch: &mut Stopwatch) -> u64 {
    stopwatch.lap();
    stopwatch.instructions()
}

/// Draws a frame. Prints its checksum, and the instructions to compute it before it is drawn.
fn draw(frame: usize, animation: &mut PreparedAnimation<'_>, stopwatch: &mut Stopwatch) {
    let before = lap(stopwatch);
    let prepared = match animation.frame(TIMES[frame]) {
        Ok(prepared) => prepared,
        Err(error) => return mps2::print(format_args!("error: {error}\n")),
    };
    let moving = lap(stopwatch) - before;
    let checksum = checksum(&prepared);
    mps2::print(format_args!(
        "checksum {frame}: {checksum:08x}\nframe {frame}: {moving}\n"
    ));
}

/// Returns the CRC-32 of the 16-bit linear samples of the frame, row by row.
fn checksum(scene: &PreparedScene<'_>) -> u32 {
    let mut renderer = Renderer::new(scene, Size::new(SIZE[0], SIZE[1]));
    let mut crc = Crc32::new();
    let mut line = [Color::<u16>::default(); WIDTH];
    for y in 0..SIZE[1] {
        renderer.render_line(y, &mut line);
        line.iter().for_each(|pixel| crc.update_pixel(*pixel));
    }
    crc.finish()
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    mps2::print(format_args!("error: {info}\n"));
    mps2::exit();
}
