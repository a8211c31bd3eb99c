//! Draws any compiled scene at any size, without a display, on QEMU's mps2
//! boards.

#![no_std]
#![no_main]

use core::panic::PanicInfo;

use cortex_m::peripheral::Peripherals;
use cortex_m_rt::entry;
use measure::{Report, Stopwatch};
use mps2::{Blind, Job};
use whitted::{DecodeError, Renderer, SceneBuffer};

#[cfg(not(feature = "crowd"))]
type Buffer = SceneBuffer<64, 8, 64>;
#[cfg(feature = "crowd")]
type Buffer = SceneBuffer<256, 1, 1>;
type File = [u8; 16 * 1024];

#[entry]
fn main() -> ! {
    static mut BUFFER: Buffer = SceneBuffer::new();
    static mut FILE: File = [0; size_of::<File>()];

    match (Job::read(FILE), Peripherals::take()) {
        (Ok(job), Some(core)) => {
            let stopwatch = Stopwatch::new(core.SYST, mps2::NANOSECONDS_PER_CLOCK);
            match draw(BUFFER, &job, stopwatch) {
                Ok(report) => {
                    mps2::print(format_args!("{report}file: {}\n", size_of::<File>()));
                }
                Err(error) => mps2::print(format_args!("error: {error}\n")),
            }
        }
        (Err(error), _) => mps2::print(format_args!("error: {error}\n")),
        (_, None) => mps2::print("error: no peripherals\n"),
    }
    mps2::exit();
}

fn draw(
    buffer: &mut Buffer,
    job: &Job<'_>,
    mut stopwatch: Stopwatch,
) -> Result<Report, DecodeError> {
    let scene = buffer.decode(job.file)?;
    let mut renderer = Renderer::new(&scene, job.size);
    let Ok(report) = measure::draw(&mut renderer, &mut Blind::new(job.size), &mut stopwatch);
    Ok(report)
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    mps2::print(format_args!("error: {info}\n"));
    mps2::exit();
}
