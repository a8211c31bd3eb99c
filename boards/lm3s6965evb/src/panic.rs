//! Panic handler, which prints the file and line of the panic on the UART.
//!
//! The handler does not print the panic message. The code that formats panic messages would
//! be larger than the ray tracer.

use core::fmt::Write;
use core::panic::PanicInfo;

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    let mut uart = crate::board::panic_uart();
    if let Some(location) = info.location() {
        _ = writeln!(
            uart,
            "error: panic in {}, line {}",
            location.file(),
            location.line()
        );
    }
    _ = writeln!(uart, "{}", measure::END);
    loop {
        cortex_m::asm::wfi();
    }
}
