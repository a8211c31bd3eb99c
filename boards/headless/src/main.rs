//! Draws any compiled scene at any size, without a display.
//!
//! For QEMU's mps2-an385 (Cortex-M3, also with code for the M0) and mps2-an386
//! (Cortex-M4F). It is told by semihosting what to draw, as its command line:
//! size, then file, `320x240 target/scene.bin`.

#![no_std]
#![no_main]

mod blind;
mod host;

use core::ffi::CStr;
use core::fmt;
use core::panic::PanicInfo;

use cortex_m::peripheral::Peripherals;
use cortex_m_rt::entry;
use embedded_graphics_core::prelude::Size;
use measure::{Report, Stopwatch};
use whitted::{DecodeError, Renderer, SceneBuffer};

use blind::Blind;

/// The clock of the mps2 boards, 25 MHz.
const NANOSECONDS_PER_CLOCK: u32 = 40;

type Buffer = SceneBuffer<64, 8, 64>;
type File = [u8; 16 * 1024];

#[entry]
fn main() -> ! {
    static mut BUFFER: Buffer = SceneBuffer::new();
    static mut FILE: File = [0; size_of::<File>()];

    match draw(BUFFER, FILE) {
        Ok(report) => host::print(report),
        Err(error) => host::print(format_args!("error: {error}\n")),
    }
    host::exit();
}

fn draw(buffer: &mut Buffer, file: &mut File) -> Result<Report, Failure> {
    let mut command_line = [0; 512];
    let (size, path) = host::command_line(&mut command_line)
        .and_then(parse)
        .ok_or(Failure::CommandLine)?;
    let bytes = host::read_file(path, file).ok_or(Failure::File)?;
    let scene = buffer.decode(bytes).map_err(Failure::Scene)?;

    let core = Peripherals::take().ok_or(Failure::CommandLine)?;
    let mut stopwatch = Stopwatch::new(core.SYST, NANOSECONDS_PER_CLOCK);
    let mut renderer = Renderer::new(&scene, size);
    let Ok(report) = measure::draw(&mut renderer, &mut Blind::new(size), &mut stopwatch);
    Ok(report)
}

/// Takes "WIDTHxHEIGHT PATH" apart.
fn parse(command_line: &CStr) -> Option<(Size, &CStr)> {
    let (first, _) = command_line.to_str().ok()?.split_once(' ')?;
    let (width, height) = first.split_once('x')?;
    let size = Size::new(width.parse().ok()?, height.parse().ok()?);
    let rest = command_line.to_bytes_with_nul().get(first.len() + 1..)?;
    Some((size, CStr::from_bytes_until_nul(rest).ok()?))
}

enum Failure {
    CommandLine,
    File,
    Scene(DecodeError),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::CommandLine => f.write_str("the command line is not WIDTHxHEIGHT FILE"),
            Self::File => write!(
                f,
                "the file cannot be read, or is over {} bytes",
                size_of::<File>()
            ),
            Self::Scene(error) => error.fmt(f),
        }
    }
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    host::print(format_args!("error: {info}\n"));
    host::exit();
}
