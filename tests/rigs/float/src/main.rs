//! Draws any scene in single precision, with the oracle of the library's
//! tests: what the instructions of the fixed-point renderer are compared with.
//!
//! It does the work of `headless`, for the same scene, size, core and display,
//! as a plain tracer in floats would: no table, no culling, no shortcut. What
//! the core can do by itself it does: floats in hardware on the M4F, M7 and
//! M33, roots included; elsewhere by the compiler's own routines. Nothing is in
//! double precision.

#![no_std]
#![no_main]

mod scene;

use core::panic::PanicInfo;

use cortex_m::peripheral::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics_core::pixelcolor::Rgb565;
use embedded_graphics_core::prelude::*;
use embedded_graphics_core::primitives::Rectangle;
use measure::{Report, Stopwatch};
use mps2::{Blind, Job};
use whitted_oracle::{Color, Scene};

use scene::Room;

type File = [u8; 16 * 1024];

#[entry]
fn main() -> ! {
    static mut ROOM: Room = Room::EMPTY;
    static mut FILE: File = [0; size_of::<File>()];

    match (Job::read(FILE), Peripherals::take()) {
        (Ok(job), Some(core)) => {
            let stopwatch = Stopwatch::new(core.SYST, mps2::NANOSECONDS_PER_CLOCK);
            match draw(ROOM, &job, stopwatch) {
                Ok(report) => mps2::print(report),
                Err(error) => mps2::print(format_args!("error: {error}\n")),
            }
        }
        (Err(error), _) => mps2::print(format_args!("error: {error}\n")),
        (_, None) => mps2::print("error: no peripherals\n"),
    }
    mps2::exit();
}

fn draw(
    room: &mut Room,
    job: &Job<'_>,
    mut stopwatch: Stopwatch,
) -> Result<Report, postcard::Error> {
    let scene = room.decode(job.file)?;
    let Ok(()) = trace(&scene, &mut Blind::new(job.size), &mut stopwatch);
    Ok(Report::new(job.size, &stopwatch))
}

/// Line by line, as the fixed-point renderer draws.
fn trace<D>(
    scene: &Scene<'_, f32>,
    target: &mut D,
    stopwatch: &mut Stopwatch,
) -> Result<(), D::Error>
where
    D: DrawTarget<Color = Rgb565> + OriginDimensions,
{
    let Size { width, height } = target.size();
    let view = scene.camera.view(width, height);
    for y in 0..height {
        let row = Rectangle::new(Point::new(0, y as i32), Size::new(width, 1));
        let pixels = (0..width).map(|x| shown(scene.pixel(&view, x, y)));
        target.fill_contiguous(&row, pixels)?;
        stopwatch.lap();
    }
    Ok(())
}

/// Clipped, then rounded to the nearest level.
fn shown(color: Color<f32>) -> Rgb565 {
    // A cast clips below, at no price.
    let level = |value: f32, max: u8| ((value * f32::from(max) + 0.5) as u32).min(max.into()) as u8;
    Rgb565::new(
        level(color.x, Rgb565::MAX_R),
        level(color.y, Rgb565::MAX_G),
        level(color.z, Rgb565::MAX_B),
    )
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    mps2::print(format_args!("error: {info}\n"));
    mps2::exit();
}
