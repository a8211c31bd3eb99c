//! Implementation in assembly for Armv6-M.
//!
//! A full product of `a` and `b` is computed from the 16-bit halves of the factors, where
//! `ah` is the upper and `al` the lower half of `a`:
//! `a * b = ah * bh * 2^32 + (al * bh + ah * bl) * 2^16 + al * bl`.
//! The upper half of a signed factor is signed. Each product of two halves fits 32 bits.
//!
//! Squares are inlined. The other assembly routines are functions with a custom calling
//! convention: a function changes only the registers that are named at the call. Calling a
//! routine takes two more instructions than inlining it, but saves much flash.

use core::arch::{asm, naked_asm};

/// Defines a function that multiplies r0 by r1 and returns the product in r1:r0.
///
/// The routine extracts the upper half of a factor by a shift: `asrs` if the factor is
/// signed, `lsrs` if it is unsigned.
macro_rules! routine {
    ($name:ident, $shift_a:literal, $shift_b:literal) => {
        #[unsafe(naked)]
        extern "C" fn $name() {
            naked_asm!(
                "uxth r2, r0",
                concat!($shift_a, " r0, r0, #16"),
                "uxth r3, r1",
                concat!($shift_b, " r1, r1, #16"),
                "movs r4, r2",
                "muls r4, r3, r4", // al bl
                "muls r2, r1, r2", // al bh
                "muls r3, r0, r3", // ah bl
                "muls r1, r0, r1", // ah bh
                "lsls r0, r2, #16",
                concat!($shift_b, " r2, r2, #16"),
                "adds r0, r0, r4",
                "adcs r1, r1, r2",
                "lsls r2, r3, #16",
                concat!($shift_a, " r3, r3, #16"),
                "adds r0, r0, r2",
                "adcs r1, r1, r3",
                "bx lr",
            )
        }
    };
}

/// Calls a routine that multiplies. Returns the lower and the upper word of the product.
macro_rules! call {
    ($routine:ident, $a:ident, $b:ident) => {{
        let (low, high);
        // SAFETY: the routine changes only the named registers and accesses no memory. A
        // linker veneer for a far call may use r12 and the stack.
        unsafe {
            asm!(
                "bl {routine}",
                routine = sym $routine,
                inout("r0") $a => low,
                inout("r1") $b => high,
                out("r2") _,
                out("r3") _,
                out("r4") _,
                out("r12") _,
                out("lr") _,
                options(pure, nomem),
            );
        }
        (low, high)
    }};
}

routine!(multiply_signed, "asrs", "asrs");
routine!(multiply_unsigned, "lsrs", "lsrs");
routine!(multiply_mixed, "asrs", "lsrs");

#[inline(always)]
pub(crate) fn signed(a: i32, b: i32) -> i64 {
    let (low, high): (u32, i32) = call!(multiply_signed, a, b);
    i64::from(high) << 32 | i64::from(low)
}

#[inline(always)]
pub(crate) fn unsigned(a: u32, b: u32) -> u64 {
    let (low, high): (u32, u32) = call!(multiply_unsigned, a, b);
    u64::from(high) << 32 | u64::from(low)
}

#[inline(always)]
pub(crate) fn mixed(a: i32, b: u32) -> i64 {
    let (low, high): (u32, i32) = call!(multiply_mixed, a, b);
    i64::from(high) << 32 | i64::from(low)
}

/// Defines the assembler macro `multiply x`. The macro sets the register `x` to
/// `x * b / 2^(32 - up)`, rounded half up.
///
/// The 16-bit halves of `b` are in r4 (`bl`, the lower half) and r3 (`bh`, the upper half),
/// and r7 is 0. The halves of `x` are `al` and `ah`. All halves are signed, so the sum
/// `al * bl / 2^16 + al * bh + ah * bl` fits 32 bits. Each right shift leaves the rounding
/// bit in the carry flag.
macro_rules! define_multiply {
    () => {
        r"
        .macro multiply x
            sxth r6, \x
            asrs \x, \x, #16
            adcs \x, r7
            movs r5, r6
            muls r5, r4, r5     // al bl
            asrs r5, r5, #16
            muls r6, r3, r6     // al bh
            adds r5, r5, r6
            movs r6, \x
            muls r6, r4, r6     // ah bl
            adds r5, r5, r6
            muls \x, r3, \x     // ah bh
        .if {up}
            lsls \x, \x, #{up}
        .endif
            asrs r5, r5, #(16 - {up})
            adcs \x, r5
        .endm"
    };
}

/// Splits r3 into two signed 16-bit halves. The lower half moves to r4, and the upper half
/// stays in r3. Also clears r7. The macro `multiply` expects its factor `b` in these
/// registers.
macro_rules! split {
    () => {
        "
        movs r7, #0
        sxth r4, r3
        asrs r3, r3, #16
        adcs r3, r7"
    };
}

/// Multiplies r0 by r3 and divides the product by `2^(32 - UP)`, rounded half up.
#[unsafe(naked)]
extern "C" fn scale_one<const UP: u32>() {
    naked_asm!(
        define_multiply!(),
        "push {{r6, r7}}",
        split!(),
        "multiply r0",
        ".purgem multiply",
        "pop {{r6, r7}}",
        "bx lr",
        up = const UP,
    )
}

/// Multiplies each of r0, r1 and r2 by r3 and divides the products by `2^(32 - UP)`,
/// rounded half up.
#[unsafe(naked)]
extern "C" fn scale<const UP: u32>() {
    naked_asm!(
        define_multiply!(),
        "push {{r6, r7}}",
        split!(),
        "multiply r0",
        "multiply r1",
        "multiply r2",
        ".purgem multiply",
        "pop {{r6, r7}}",
        "bx lr",
        up = const UP,
    )
}

/// Multiplies each of r0, r1 and r2 by `r3 + 2^32` and divides the products by 2^32,
/// rounded half up.
///
/// The routine multiplies each register by the signed value in r3, then adds the original
/// value of the register.
#[unsafe(naked)]
extern "C" fn reduce() {
    naked_asm!(
        define_multiply!(),
        "push {{r6, r7}}",
        split!(),
        "mov r12, r0",
        "multiply r0",
        "add r0, r12",
        "mov r12, r1",
        "multiply r1",
        "add r1, r12",
        "mov r12, r2",
        "multiply r2",
        "add r2, r12",
        ".purgem multiply",
        "pop {{r6, r7}}",
        "bx lr",
        up = const 0,
    )
}

/// Calls a vector routine, which takes the components in r0 to r2 and the factor in r3.
macro_rules! call_vector {
    ($routine:path, $v:ident, $by:expr) => {{
        let [mut x, mut y, mut z] = $v;
        // SAFETY: the routine changes only the named registers and accesses no memory
        // except its stack frame. A linker veneer for a far call may use r12.
        unsafe {
            asm!(
                "bl {routine}",
                routine = sym $routine,
                inout("r0") x,
                inout("r1") y,
                inout("r2") z,
                inout("r3") $by => _,
                out("r4") _,
                out("r5") _,
                out("r12") _,
                out("lr") _,
                options(pure, nomem),
            );
        }
        [x, y, z]
    }};
}

#[inline(always)]
pub(crate) fn upper(mut a: i32, b: i32) -> i32 {
    // SAFETY: the routine changes only the named registers and accesses no memory except
    // its stack frame. A linker veneer for a far call may use r12.
    unsafe {
        asm!(
            "bl {routine}",
            routine = sym scale_one::<1>,
            inout("r0") a,
            inout("r3") b => _,
            out("r4") _,
            out("r5") _,
            out("r12") _,
            out("lr") _,
            options(pure, nomem),
        );
    }
    a
}

#[inline(always)]
pub(crate) fn scaled<const SHIFT: u32>(v: [i32; 3], by: i32) -> [i32; 3] {
    if SHIFT == 29 {
        call_vector!(scale::<3>, v, by)
    } else {
        call_vector!(scale::<2>, v, by)
    }
}

#[inline(always)]
pub(crate) fn reduced(v: [i32; 3], by: u32) -> [i32; 3] {
    call_vector!(reduce, v, by)
}

#[inline(always)]
pub(crate) fn by_16_bits(a: u32, b: i32) -> i32 {
    let (low, high) = (b as u32 & 0xffff, (b >> 16) as u32);
    let sum = a.wrapping_mul(low) >> 16;
    sum.wrapping_add(a.wrapping_mul(high)) as i32 >> 15
}

#[inline(always)]
pub(crate) fn by_17_bits(a: u32, b: u32) -> u32 {
    // The product `a * low` fits in 32 bits, and the sum of both terms is at most `b`.
    // Therefore nothing overflows.
    let (low, high) = (b & 0xffff, b >> 16);
    (a.wrapping_mul(low) >> 16).wrapping_add(a.wrapping_mul(high)) >> 1
}

#[inline(always)]
pub(crate) fn middle(a: u32, b: u32) -> u32 {
    let (al, ah, bl, bh) = (a & 0xffff, a >> 16, b & 0xffff, b >> 16);
    (al.wrapping_mul(bl) >> 16)
        .wrapping_add(al.wrapping_mul(bh))
        .wrapping_add(ah.wrapping_mul(bl))
        .wrapping_add(ah.wrapping_mul(bh) << 16)
}

#[inline(always)]
pub(crate) fn square_of_21_bits(a: u32) -> u32 {
    let (upper, lower) = (a >> 10, a & 0x3ff);
    let upper_square = upper.wrapping_mul(upper) << 10;
    let twice = upper.wrapping_mul(lower) << 1;
    upper_square
        .wrapping_add(twice)
        .wrapping_add(lower.wrapping_mul(lower) >> 10)
}

#[inline(always)]
pub(crate) fn square(a: i32) -> i64 {
    let (low, high): (u32, i32);
    // SAFETY: the code changes only the named registers and accesses no memory.
    unsafe {
        asm!(
            "uxth {middle}, {a}",
            "asrs {a}, {a}, #16",
            "movs {low}, {middle}",
            "muls {low}, {middle}, {low}",   // al²
            "muls {middle}, {a}, {middle}",  // al ah
            "muls {a}, {a}, {a}",            // ah²
            "lsls {twice}, {middle}, #17",
            "asrs {middle}, {middle}, #15",
            "adds {low}, {low}, {twice}",
            "adcs {a}, {a}, {middle}",
            a = inout(reg) a => high,
            middle = out(reg) _,
            twice = out(reg) _,
            low = out(reg) low,
            options(pure, nomem, nostack),
        );
    }
    i64::from(high) << 32 | i64::from(low)
}

/// Counts the leading zeros of r0. The routine finds the highest nonzero byte and looks up
/// its leading zeros in a table of 256 entries.
#[unsafe(naked)]
extern "C" fn count_leading_zeros() {
    naked_asm!(
        "adr r2, 4f",
        "lsrs r1, r0, #24",
        "bne 1f",
        "lsrs r1, r0, #16",
        "bne 2f",
        "lsrs r1, r0, #8",
        "bne 3f",
        "ldrb r0, [r2, r0]",
        "adds r0, #24",
        "bx lr",
        "1:",
        "ldrb r0, [r2, r1]",
        "bx lr",
        "2:",
        "ldrb r0, [r2, r1]",
        "adds r0, #8",
        "bx lr",
        "3:",
        "ldrb r0, [r2, r1]",
        "adds r0, #16",
        "bx lr",
        ".p2align 2",
        "4:",
        ".byte 8, 7, 6, 6",
        ".fill 4, 1, 5",
        ".fill 8, 1, 4",
        ".fill 16, 1, 3",
        ".fill 32, 1, 2",
        ".fill 64, 1, 1",
        ".fill 128, 1, 0",
    )
}

#[inline(always)]
pub(crate) fn leading_zeros(x: u32) -> u32 {
    let zeros;
    // SAFETY: the routine changes only the named registers and reads only its constant
    // table. A linker veneer for a far call may use r12 and the stack.
    unsafe {
        asm!(
            "bl {routine}",
            routine = sym count_leading_zeros,
            inout("r0") x => zeros,
            out("r1") _,
            out("r2") _,
            out("r12") _,
            out("lr") _,
            options(pure, nomem),
        );
    }
    zeros
}

#[inline(always)]
pub(crate) fn rounded<const SHIFT: u32>(x: i64) -> i32 {
    let result;
    // SAFETY: the code changes only the named registers and accesses no memory.
    unsafe {
        asm!(
            "lsls {high}, {high}, #{up}",
            "lsrs {low}, {low}, #{down}", // carry: the rounding bit
            "adcs {low}, {low}, {high}",
            low = inout(reg) x as i32 => result,
            high = inout(reg) (x >> 32) as i32 => _,
            down = const SHIFT,
            up = const 32 - SHIFT,
            options(pure, nomem, nostack),
        );
    }
    result
}
