//! By halves of 16 bits, the upper ones signed where the number is:
//! `a b = ah bh 2^32 + (al bh + ah bl) 2^16 + al bl`.
//!
//! The four products of halves fit 32 bits. Squares are inlined; the others are
//! calls that leave every register but the named ones alone, which takes two
//! instructions more than inlining them and far less flash.

use core::arch::{asm, naked_asm};

/// A function that multiplies r0 by r1 into r1:r0, with the shifts that split
/// off the upper halves.
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

/// Calls a routine and gives both words of the product.
macro_rules! call {
    ($routine:ident, $a:ident, $b:ident) => {{
        let (low, high);
        // SAFETY: the routine changes the named registers alone, and takes no
        // memory. The linker may go by r12, and by the stack, to one far away.
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

/// Instructions that multiply a register by r4 and r3, the lower and the upper half of a
/// number, and round the product's upper part into the register. Halves are signed, the
/// lower one too, so that all but the product of the upper ones fits 32 bits:
/// `(al bl) / 2^16 + al bh + ah bl`. What a shift leaves in the carry rounds. r7 is 0.
macro_rules! multiply_rounded {
    ($x:literal, $up:literal, $down:literal) => {
        concat!(
            "sxth r6, ",
            $x,
            "\n",
            "asrs ",
            $x,
            ", ",
            $x,
            ", #16\n",
            "adcs ",
            $x,
            ", r7\n",
            "movs r5, r6\n",
            "muls r5, r4, r5\n", // al bl
            "asrs r5, r5, #16\n",
            "muls r6, r3, r6\n", // al bh
            "adds r5, r5, r6\n",
            "movs r6, ",
            $x,
            "\n",
            "muls r6, r4, r6\n", // ah bl
            "adds r5, r5, r6\n",
            "muls ",
            $x,
            ", r3, ",
            $x,
            "\n", // ah bh
            $up,
            "\n",
            "asrs r5, r5, #",
            $down,
            "\n",
            "adcs ",
            $x,
            ", r5\n",
        )
    };
}

/// Multiplies r0 by r1 into the upper bits of the product.
#[unsafe(naked)]
extern "C" fn multiply_upper() {
    naked_asm!(
        "push {{r6, r7}}",
        "movs r7, #0",
        "sxth r4, r1",
        "asrs r3, r1, #16",
        "adcs r3, r7",
        multiply_rounded!("r0", "lsls r0, r0, #1", "15"),
        "pop {{r6, r7}}",
        "bx lr",
    )
}

/// A function that multiplies each of r0, r1 and r2 by r3 and keeps r6 and up.
macro_rules! vector_routine {
    ($name:ident, $x:expr, $y:expr, $z:expr) => {
        #[unsafe(naked)]
        extern "C" fn $name() {
            naked_asm!(
                "push {{r6, r7}}",
                "movs r7, #0",
                "sxth r4, r3",
                "asrs r3, r3, #16",
                "adcs r3, r7",
                $x,
                $y,
                $z,
                "pop {{r6, r7}}",
                "bx lr",
            )
        }
    };
}

vector_routine!(
    scale_29,
    multiply_rounded!("r0", "lsls r0, r0, #3", "13"),
    multiply_rounded!("r1", "lsls r1, r1, #3", "13"),
    multiply_rounded!("r2", "lsls r2, r2, #3", "13")
);
vector_routine!(
    scale_30,
    multiply_rounded!("r0", "lsls r0, r0, #2", "14"),
    multiply_rounded!("r1", "lsls r1, r1, #2", "14"),
    multiply_rounded!("r2", "lsls r2, r2, #2", "14")
);
// r3 is less by 2^32 than what is meant, so each is added once.
vector_routine!(
    reduce,
    concat!(
        "mov r12, r0\n",
        multiply_rounded!("r0", "", "16"),
        "add r0, r12"
    ),
    concat!(
        "mov r12, r1\n",
        multiply_rounded!("r1", "", "16"),
        "add r1, r12"
    ),
    concat!(
        "mov r12, r2\n",
        multiply_rounded!("r2", "", "16"),
        "add r2, r12"
    )
);

/// Calls a routine for vectors.
macro_rules! call_vector {
    ($routine:ident, $v:ident, $by:expr) => {{
        let [mut x, mut y, mut z] = $v;
        // SAFETY: the routine changes the named registers alone, and takes no memory but
        // the stack. The linker may go by r12 to one far away.
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
    // SAFETY: as for vectors.
    unsafe {
        asm!(
            "bl {routine}",
            routine = sym multiply_upper,
            inout("r0") a,
            in("r1") b,
            out("r3") _,
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
        call_vector!(scale_29, v, by)
    } else {
        call_vector!(scale_30, v, by)
    }
}

#[inline(always)]
pub(crate) fn reduced(v: [i32; 3], by: u32) -> [i32; 3] {
    call_vector!(reduce, v, by)
}

#[inline(always)]
pub(crate) fn step(a: u16, b: i32) -> i32 {
    let a = u32::from(a);
    let (low, high) = (b as u32 & 0xffff, (b >> 16) as u32);
    let sum = a.wrapping_mul(low) >> 16;
    sum.wrapping_add(a.wrapping_mul(high)) as i32 >> 15
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
    // SAFETY: changes the named registers alone.
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

/// By bytes, and a table for the first that is not 0.
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
    // SAFETY: as for products; memory is read, but nothing that changes.
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
