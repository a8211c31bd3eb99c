//! The host, by semihosting.

use core::cell::Cell;
use core::ffi::CStr;
use core::fmt::{Display, Write};

use cortex_m_semihosting::nr::{GET_CMDLINE, open::R_BINARY};
use cortex_m_semihosting::{debug, hio, syscall};

/// Prints on the host's standard output. Where the host takes no text, there
/// is nobody left to tell.
pub fn print(text: impl Display) {
    if let Ok(mut output) = hio::hstdout() {
        _ = write!(output, "{text}");
    }
}

/// Ends QEMU.
pub fn exit() -> ! {
    debug::exit(debug::EXIT_SUCCESS);
    loop {
        cortex_m::asm::wfi();
    }
}

/// The arguments that QEMU was given for the firmware.
pub(crate) fn command_line(buffer: &mut [u8]) -> Option<&CStr> {
    // In cells, as the host overwrites the length.
    let request = [buffer.as_mut_ptr().expose_provenance(), buffer.len()].map(Cell::new);
    // SAFETY: the call takes a buffer to write to, and its length.
    let result = unsafe { cortex_m_semihosting::syscall(GET_CMDLINE, &request) };
    if result != 0 {
        return None;
    }
    CStr::from_bytes_until_nul(buffer).ok()
}

/// What the file holds; `None` if it cannot be read or does not fit.
pub(crate) fn read_file<'b>(path: &CStr, buffer: &'b mut [u8]) -> Option<&'b [u8]> {
    let name = path.as_ptr().expose_provenance();
    // SAFETY: the call takes a text that ends in a 0, the mode, and the length.
    let file = unsafe { syscall!(OPEN, name, R_BINARY, path.count_bytes()) };
    if file == usize::MAX {
        return None;
    }
    // SAFETY: the call takes an open file.
    let length = unsafe { syscall!(FLEN, file) };
    let bytes = buffer.get_mut(..length)?;
    let start = bytes.as_mut_ptr().expose_provenance();
    // SAFETY: the call takes an open file, a buffer to write to, and its length.
    let missing = unsafe { syscall!(READ, file, start, length) };
    (missing == 0).then_some(bytes)
}
