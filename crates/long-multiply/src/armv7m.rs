//! Rounding shift for Armv7-M and Armv8-M mainline.
//!
//! A right shift leaves the last bit that it shifts out in the carry flag. Adding the carry
//! flag to the shifted value rounds half up, so shift and rounding take 2 instructions.
//! Compiled code takes 4, because it adds half a unit to the 64-bit value first.

use core::arch::asm;

#[inline(always)]
pub(crate) fn rounded<const SHIFT: u32>(x: i64) -> i32 {
    let result;
    // SAFETY: the code changes only the named registers and accesses no memory.
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
