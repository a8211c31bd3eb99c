//! Draws frames of an animated scene that is stored in flash. Before each frame, counts the
//! instructions to evaluate the animation, prepare the scene, and set the camera.

#![no_std]
#![no_main]

mod scene;

use core::panic::PanicInfo;

use cortex_m::peripheral::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics_core::prelude::Size;
use measure::Stopwatch;
use scene::{ANIMATION, SCENE, SIZE, TIMES};
use whitted::animation::AnimatedScene;
use whitted::codec::Crc32;
use whitted::{Color, PreparedScene, Renderer, SceneBuffer};

const WIDTH: usize = SIZE[0] as usize;

#[entry]
fn main() -> ! {
    static mut BUFFER: SceneBuffer<5, 1, 5> = SceneBuffer::new();
    static mut ANIMATED: AnimatedScene<5, 1> = AnimatedScene::new();

    match Peripherals::take() {
        Some(core) => {
            let mut stopwatch = Stopwatch::new(core.SYST, mps2::NANOSECONDS_PER_CLOCK);
            for frame in 0..TIMES.len() {
                draw(frame, ANIMATED, BUFFER, &mut stopwatch);
            }
        }
        None => mps2::print("error: peripherals already taken\n"),
    }
    mps2::exit();
}

/// Draws a frame and prints its checksum and the instructions of each step.
fn draw(
    frame: usize,
    animated: &mut AnimatedScene<5, 1>,
    buffer: &mut SceneBuffer<5, 1, 5>,
    stopwatch: &mut Stopwatch,
) {
    let mut lap = || {
        let before = stopwatch.instructions();
        stopwatch.lap();
        stopwatch.instructions() - before
    };
    lap();
    let moved = match animated.frame(&SCENE, &ANIMATION, TIMES[frame]) {
        Ok(moved) => moved,
        Err(error) => return mps2::print(format_args!("error: {error}\n")),
    };
    let moving_cost = lap();
    let mut prepared = match buffer.prepare(&moved) {
        Ok(prepared) => prepared,
        Err(error) => return mps2::print(format_args!("error: {error}\n")),
    };
    let preparing_cost = lap();
    let result = prepared.set_camera(&moved.camera);
    let camera_cost = lap();
    if let Err(error) = result {
        return mps2::print(format_args!("error: {error}\n"));
    }
    let checksum = checksum(&prepared);
    mps2::print(format_args!(
        "checksum {frame}: {checksum:08x}\nmove {frame}: {moving_cost}\nprepare {frame}: {preparing_cost}\ncamera {frame}: {camera_cost}\n"
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
