//! What a shift leaves in the carry rounds: the compiler adds half a step to both words,
//! and needs twice as many instructions.

use core::arch::asm;

#[inline(always)]
pub(crate) fn rounded<const SHIFT: u32>(x: i64) -> i32 {
    let result;
    // SAFETY: changes the named register alone.
    unsafe {
        asm!(
            "lsrs {low}, {low}, #{down}",
            "adc {low}, {low}, {high}, lsl #{up}",
            low = inout(reg) x as i32 => result,
            high = in(reg) (x >> 32) as i32,
            down = const SHIFT,
            up = const 32 - SHIFT,
            options(pure, nomem, nostack),
        );
    }
    result
}
