//! Decodes a compiled scene and formats the error as text.

#![no_std]
#![no_main]

use core::fmt::Write;
use core::hint::black_box;

use choices::{Buffer, compiled, draw};
use cortex_m_rt::entry;

/// Text output that discards the text.
struct Output;

impl Write for Output {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        black_box(text);
        Ok(())
    }
}

#[entry]
fn main() -> ! {
    match Buffer::new().decode(compiled()) {
        Ok(scene) => draw(&scene),
        Err(error) => _ = write!(Output, "{error}"),
    }
    loop {
        core::hint::spin_loop();
    }
}
