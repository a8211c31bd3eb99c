//! Draws any compiled scene on QEMU's virt machine, a RISC-V core, and prints
//! the checksum of the picture.
//!
//! QEMU puts the job into memory: width, height and length as words, a page
//! further the compiled scene.

#![no_std]
#![no_main]

use core::fmt::{self, Write};
use core::panic::PanicInfo;

use embedded_graphics_core::geometry::Size;
use riscv_rt::entry;
use whitted::codec::Crc32;
use whitted::{Color, Renderer, SceneBuffer};

/// What QEMU is told to write to: `xtask/src/prove/everywhere.rs` does so.
const JOB: *const [u32; 3] = 0x8100_0000_u32 as _;
const SCENE: *const u8 = 0x8100_1000_u32 as _;

/// The transmit register of the machine's UART.
const UART: *mut u8 = 0x1000_0000_u32 as _;
/// Ends QEMU.
const FINISHER: *mut u32 = 0x0010_0000_u32 as _;
const SUCCESS: u32 = 0x5555;

#[entry]
fn main() -> ! {
    // SAFETY: QEMU has written the job before it has started the core; it lies
    // beyond what memory.x names, and nobody writes to it.
    let [width, height, length] = unsafe { JOB.read_volatile() };
    // SAFETY: the same, of as many bytes as the job says.
    let scene = unsafe { core::slice::from_raw_parts(SCENE, length as usize) };
    let mut buffer = SceneBuffer::<64, 8, 64>::new();
    _ = match buffer.decode(scene) {
        Ok(scene) => {
            let mut renderer = Renderer::new(&scene, Size::new(width, height));
            writeln!(Uart, "checksum: {:08x}", checksum(&mut renderer))
        }
        Err(error) => writeln!(Uart, "error: {error}"),
    };
    exit()
}

fn checksum(renderer: &mut Renderer<'_>) -> u32 {
    let mut crc = Crc32::new();
    let mut line = [Color::<u16>::default(); 320];
    let Size { width, height } = renderer.size();
    for y in 0..height {
        renderer.render_line(y, &mut line);
        line.iter()
            .take(width as usize)
            .for_each(|pixel| crc.update_pixel(*pixel));
    }
    crc.finish()
}

struct Uart;

impl Write for Uart {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            // SAFETY: the register of a device that is always ready, in QEMU.
            unsafe { UART.write_volatile(byte) }
        }
        Ok(())
    }
}

fn exit() -> ! {
    // SAFETY: a device's register; the machine ends with this.
    unsafe { FINISHER.write_volatile(SUCCESS) }
    loop {}
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    _ = writeln!(Uart, "error: {info}");
    exit()
}
