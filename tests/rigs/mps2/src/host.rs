//! Semihosting calls to the host that runs QEMU.

use core::cell::Cell;
use core::ffi::CStr;
use core::fmt::{Display, Write};

use cortex_m_semihosting::nr::{GET_CMDLINE, open::R_BINARY};
use cortex_m_semihosting::{debug, hio, syscall};

/// Prints text on the standard output of the host. Errors are ignored.
pub fn print(text: impl Display) {
    if let Ok(mut output) = hio::hstdout() {
        _ = write!(output, "{text}");
    }
}

/// Exits QEMU.
pub fn exit() -> ! {
    debug::exit(debug::EXIT_SUCCESS);
    loop {
        cortex_m::asm::wfi();
    }
}

/// Returns the command line that QEMU passes to the firmware.
pub(crate) fn command_line(buffer: &mut [u8]) -> Option<&CStr> {
    // The request consists of `Cell`s, because the host overwrites the length.
    let request = [buffer.as_mut_ptr().expose_provenance(), buffer.len()].map(Cell::new);
    // SAFETY: SYS_GET_CMDLINE takes a writable buffer and its length.
    let result = unsafe { cortex_m_semihosting::syscall(GET_CMDLINE, &request) };
    if result != 0 {
        return None;
    }
    CStr::from_bytes_until_nul(buffer).ok()
}

/// Reads a file of the host. Returns `None` if it is unreadable or exceeds the buffer.
pub(crate) fn read_file<'b>(path: &CStr, buffer: &'b mut [u8]) -> Option<&'b [u8]> {
    let name = path.as_ptr().expose_provenance();
    // SAFETY: SYS_OPEN takes a NUL-terminated path, the mode, and the path length.
    let file = unsafe { syscall!(OPEN, name, R_BINARY, path.count_bytes()) };
    if file == usize::MAX {
        return None;
    }
    // SAFETY: SYS_FLEN takes the handle of an open file.
    let length = unsafe { syscall!(FLEN, file) };
    let bytes = buffer.get_mut(..length)?;
    let start = bytes.as_mut_ptr().expose_provenance();
    // SAFETY: SYS_READ takes the handle of an open file, a writable buffer and its length.
    let missing = unsafe { syscall!(READ, file, start, length) };
    (missing == 0).then_some(bytes)
}
