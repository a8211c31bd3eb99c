//! Memory usage, from the symbols of the cortex-m-rt linker script.

use cortex_m_rt::STACK_PAINT_VALUE;

unsafe extern "C" {
    static __vector_table: u32;
    static __sidata: u32;
    static __sdata: u32;
    static __edata: u32;
    static __ebss: u32;
    static _stack_end: u32;
    static _stack_start: u32;
}

/// Returns the size of the firmware in flash, in bytes. The size includes the vectors, the
/// code, the constants and the initial values of statics.
pub(crate) fn flash() -> usize {
    distance(&raw const __vector_table, &raw const __sidata)
        + distance(&raw const __sdata, &raw const __edata)
}

/// Returns the RAM size of all statics, in bytes.
pub(crate) fn statics() -> usize {
    distance(&raw const __sdata, &raw const __ebss)
}

/// Returns the deepest stack usage so far, in bytes.
///
/// cortex-m-rt fills the stack with a known value before `main`. The lowest word with
/// another value marks the deepest usage.
pub fn peak_stack() -> usize {
    let start = &raw const _stack_start;
    let mut word = &raw const _stack_end;
    // SAFETY: the words from `_stack_end` to `_stack_start` are initialized RAM that only
    // the stack uses. This loop only reads them.
    while word < start && unsafe { word.read_volatile() } == STACK_PAINT_VALUE {
        word = word.wrapping_add(1);
    }
    distance(word, start)
}

fn distance(from: *const u32, to: *const u32) -> usize {
    to.addr() - from.addr()
}
