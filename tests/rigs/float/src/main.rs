//! Draws a scene in `f32` with the reference tracer of the tests.
//!
//! `cargo xtask bench` compares the instruction count of the `float` rig with that of the
//! fixed-point renderer in the `headless` rig, for equal scenes, sizes, cores and displays.
//! The reference tracer has no tables, no culling and no special cases. The M4F, M7 and M33
//! run floating-point operations and square roots in hardware. The other cores run routines
//! of the compiler for them. No operation is in double precision.

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
use mps2::{Job, NullDisplay};
use whitted_oracle::{Color, Scene};

use scene::SceneStorage;

type File = [u8; 16 * 1024];

#[entry]
fn main() -> ! {
    static mut STORAGE: SceneStorage = SceneStorage::EMPTY;
    static mut FILE: File = [0; size_of::<File>()];

    match (Job::read(FILE), Peripherals::take()) {
        (Ok(job), Some(core)) => {
            let stopwatch = Stopwatch::new(core.SYST, mps2::NANOSECONDS_PER_CLOCK);
            match draw(STORAGE, &job, stopwatch) {
                Ok(report) => mps2::print(report),
                Err(error) => mps2::print(format_args!("error: {error}\n")),
            }
        }
        (Err(error), _) => mps2::print(format_args!("error: {error}\n")),
        (_, None) => mps2::print("error: peripherals already taken\n"),
    }
    mps2::exit();
}

fn draw(
    storage: &mut SceneStorage,
    job: &Job<'_>,
    mut stopwatch: Stopwatch,
) -> Result<Report, postcard::Error> {
    let scene = storage.decode(job.file)?;
    let Ok(()) = trace(&scene, &mut NullDisplay::new(job.size), &mut stopwatch);
    Ok(Report::new(job.size, &stopwatch))
}

/// Draws line by line, like the fixed-point renderer.
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
        let pixels = (0..width).map(|x| to_rgb565(scene.pixel(&view, x, y)));
        target.fill_contiguous(&row, pixels)?;
        stopwatch.lap();
    }
    Ok(())
}

/// Clamps a color to 0..=1 and rounds it to the nearest RGB565 level.
fn to_rgb565(color: Color<f32>) -> Rgb565 {
    // The cast to u32 clamps negative values to 0 at no extra cost.
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
