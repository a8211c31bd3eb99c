//! Draws a compiled scene on QEMU's RISC-V virt machine and prints the picture checksum.
//!
//! QEMU loads the job into memory. The job consists of width, height and scene length as
//! 32-bit words. The compiled scene follows 4 KB above the start of the job.

#![no_std]
#![no_main]

use core::fmt::{self, Write};
use core::panic::PanicInfo;

use embedded_graphics_core::geometry::Size;
use riscv_rt::entry;
use whitted::codec::Crc32;
use whitted::{Color, Renderer, SceneBuffer};

/// Load addresses of the job, as in the QEMU command line of
/// `xtask/src/prove/everywhere.rs`.
const JOB: *const [u32; 3] = 0x8100_0000_u32 as _;
const SCENE: *const u8 = 0x8100_1000_u32 as _;

/// Transmit register of the UART.
const UART: *mut u8 = 0x1000_0000_u32 as _;
/// Register of the SiFive test device. Writing to it exits QEMU.
const FINISHER: *mut u32 = 0x0010_0000_u32 as _;
const SUCCESS: u32 = 0x5555;

#[entry]
fn main() -> ! {
    // SAFETY: QEMU writes the job before it starts the core. The job is outside the memory
    // that memory.x defines, so the program does not overwrite the job.
    let [width, height, length] = unsafe { JOB.read_volatile() };
    // SAFETY: QEMU loads the `length` bytes of the scene at this address before the core
    // starts. The program does not write to these bytes.
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

/// Traces all lines and returns the CRC-32 of their 16-bit linear samples.
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
            // SAFETY: `UART` is the transmit register of the virt machine. QEMU is always
            // ready to transmit.
            unsafe { UART.write_volatile(byte) }
        }
        Ok(())
    }
}

fn exit() -> ! {
    // SAFETY: `FINISHER` is the register of the test device in the virt machine.
    unsafe { FINISHER.write_volatile(SUCCESS) }
    loop {}
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    _ = writeln!(Uart, "error: {info}");
    exit()
}
