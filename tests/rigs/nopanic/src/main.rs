//! Proves that the library cannot panic: this program links only if it contains no panic.
//!
//! The panic handler calls an undefined function, so any reachable panic is a linker
//! error. `cargo xtask test nopanic` links the program for each instruction set. The
//! program is never run. All input passes through `black_box`, so the optimizer cannot
//! remove a panic by knowing the values.

#![no_std]
#![no_main]

mod displays;
mod motion;
mod scenes;
mod text;

use core::hint::black_box;
use core::panic::PanicInfo;

use cortex_m_rt::entry;

#[entry]
fn main() -> ! {
    loop {
        scenes::build();
        scenes::prepare();
        scenes::decode();
        motion::play();
        if cfg!(feature = "broken") {
            let bytes: &[u8] = black_box(&[]);
            black_box(bytes[black_box(0)]);
        }
    }
}

unsafe extern "C" {
    safe fn something_may_panic() -> !;
}

#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    something_may_panic()
}
