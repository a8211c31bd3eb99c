//! Draws a compiled scene at a given size on QEMU's mps2 boards and prints a report.

#![no_std]
#![no_main]

use core::panic::PanicInfo;

use cortex_m::peripheral::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics_core::prelude::Size;
use measure::Stopwatch;
use mps2::{Job, NullDisplay};
use whitted::{DecodeError, PreparedScene, Renderer, SceneBuffer};

type Buffer = SceneBuffer<64, 8, 64>;
type File = [u8; 16 * 1024];

/// The scene, the renderer and the buffers are static, so the measured stack contains only
/// call frames. Decoding, setup and drawing are separate functions, so they do not share a
/// call frame.
#[entry]
fn main() -> ! {
    static mut BUFFER: Buffer = SceneBuffer::new();
    static mut SCENE: Option<PreparedScene<'static>> = None;
    static mut RENDERER: Option<Renderer<'static>> = None;
    static mut FILE: File = [0; size_of::<File>()];

    match (Job::read(FILE), Peripherals::take()) {
        (Ok(job), Some(core)) => {
            let mut stopwatch = Stopwatch::new(core.SYST, mps2::NANOSECONDS_PER_CLOCK);
            match decode(job.file, BUFFER, SCENE) {
                Ok(scene) => {
                    let renderer = set_up(scene, job.size, RENDERER);
                    let display = &mut NullDisplay::new(job.size);
                    let Ok(report) = measure::draw(renderer, display, &mut stopwatch);
                    mps2::print(format_args!("{report}file: {}\n", size_of::<File>()));
                }
                Err(error) => mps2::print(format_args!("error: {error}\n")),
            }
        }
        (Err(error), _) => mps2::print(format_args!("error: {error}\n")),
        (_, None) => mps2::print("error: peripherals already taken\n"),
    }
    mps2::exit();
}

#[inline(never)]
fn decode(
    file: &'static [u8],
    buffer: &'static mut Buffer,
    scene: &'static mut Option<PreparedScene<'static>>,
) -> Result<&'static PreparedScene<'static>, DecodeError> {
    Ok(scene.insert(buffer.decode(file)?))
}

#[inline(never)]
fn set_up(
    scene: &'static PreparedScene<'static>,
    size: Size,
    renderer: &'static mut Option<Renderer<'static>>,
) -> &'static mut Renderer<'static> {
    renderer.insert(Renderer::new(scene, size))
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    mps2::print(format_args!("error: {info}\n"));
    mps2::exit();
}
