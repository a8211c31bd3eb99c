//! Where a panic ends: told on the UART, without the message, whose formatting
//! would bring in more code than the ray tracer has.

use core::fmt::Write;
use core::panic::PanicInfo;

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    let mut uart = crate::board::last_words();
    if let Some(place) = info.location() {
        _ = writeln!(
            uart,
            "error: panic in {}, line {}",
            place.file(),
            place.line()
        );
    }
    _ = writeln!(uart, "{}", measure::END);
    loop {
        cortex_m::asm::wfi();
    }
}
