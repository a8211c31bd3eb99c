//! Sizes by the symbols of cortex-m-rt's linker script.

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

/// Bytes of flash: vectors, code, constants and the initial values of statics.
pub(crate) fn flash() -> usize {
    distance(&raw const __vector_table, &raw const __sidata)
        + distance(&raw const __sdata, &raw const __edata)
}

/// Bytes of RAM that statics take.
pub(crate) fn statics() -> usize {
    distance(&raw const __sdata, &raw const __ebss)
}

/// Bytes of stack at the deepest so far: from its start to the lowest word
/// that no longer holds the paint which the stack got before `main`.
pub fn peak_stack() -> usize {
    let start = &raw const _stack_start;
    let mut word = &raw const _stack_end;
    // SAFETY: from `_stack_end` up to `_stack_start` all is RAM, written by the
    // paint at least, and nothing but the stack lives there. The part below the
    // stack pointer belongs to nobody, the part above is only read.
    while word < start && unsafe { word.read_volatile() } == STACK_PAINT_VALUE {
        word = word.wrapping_add(1);
    }
    distance(word, start)
}

fn distance(from: *const u32, to: *const u32) -> usize {
    to.addr() - from.addr()
}
