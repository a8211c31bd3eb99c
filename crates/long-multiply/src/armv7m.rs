//! Rounding shift for Armv7-M and Armv8-M mainline.
//!
//! A right shift moves the last bit that it removes into the carry flag. Adding the carry
//! flag to the shifted value rounds it half up. Shifting and rounding therefore take 2
//! instructions. Code from the compiler takes 4, because it adds one half to the 64-bit
//! value before the shift.

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
