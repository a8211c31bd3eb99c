/// What instructions are, as far as their cycles differ.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Class {
    /// Arithmetic, moves, and branches but for what a taken one adds.
    Simple,
    Load,
    Store,
    /// Of so many registers.
    LoadMany(u32),
    StoreMany(u32),
    /// A branch that keeps where it came from.
    Call,
    Multiply,
    MultiplyAdd,
    /// With a product of 64 bits.
    LongMultiply,
    LongMultiplyAdd,
    Divide,
}

/// Whether an instruction has two halfwords.
pub(super) fn is_wide(first: u16) -> bool {
    first >> 11 >= 0b11101
}

/// The class of an instruction, from its halfwords; the second may be that of
/// the next one (Arm v7-M Architecture Reference Manual, A5).
pub(super) fn class(first: u16, second: u16) -> Class {
    if is_wide(first) {
        wide(first, second)
    } else {
        narrow(first)
    }
}

fn narrow(code: u16) -> Class {
    let is_load = code & 0x0800 != 0;
    match code >> 12 {
        0b0100 if code & 0xffc0 == 0x4340 => Class::Multiply,
        0b0100 if code & 0xf800 == 0x4800 => Class::Load,
        // STR, STRH, STRB, then five loads.
        0b0101 if (code >> 9) & 7 < 3 => Class::Store,
        0b0101 => Class::Load,
        0b0110..=0b1001 if is_load => Class::Load,
        0b0110..=0b1001 => Class::Store,
        0b1011 if code & 0xfe00 == 0xb400 => Class::StoreMany((code & 0x1ff).count_ones()),
        0b1011 if code & 0xfe00 == 0xbc00 => Class::LoadMany((code & 0x1ff).count_ones()),
        0b1100 if is_load => Class::LoadMany((code & 0xff).count_ones()),
        0b1100 => Class::StoreMany((code & 0xff).count_ones()),
        _ => Class::Simple,
    }
}

fn wide(first: u16, second: u16) -> Class {
    let is_load = first & 0x0010 != 0;
    let many = |count| match is_load {
        true => Class::LoadMany(count),
        false => Class::StoreMany(count),
    };
    match first & 0xfe00 {
        // LDRD and STRD beside LDM and STM.
        0xe800 if first & 0x0040 != 0 => many(2),
        0xe800 => many(second.count_ones()),
        // Registers of the FPU; and of the core.
        0xec00 | 0xf800 if is_load => Class::Load,
        0xec00 | 0xf800 => Class::Store,
        0xf000 | 0xf200 | 0xf400 | 0xf600 if second & 0xd000 == 0xd000 => Class::Call,
        0xfa00 => multiply(first, second),
        _ => Class::Simple,
    }
}

fn multiply(first: u16, second: u16) -> Class {
    match first & 0xfff0 {
        0xfb00 if second & 0xf0f0 != 0xf000 => Class::MultiplyAdd,
        0xfb00..=0xfb70 => Class::Multiply,
        0xfb80 | 0xfba0 => Class::LongMultiply,
        0xfb90 | 0xfbb0 => Class::Divide,
        0xfbc0..=0xfbe0 => Class::LongMultiplyAdd,
        _ => Class::Simple,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_are_told_apart() {
        for (first, second, class) in [
            (0x4601, 0, Class::Simple),               // mov r1, r0
            (0xd0fe, 0, Class::Simple),               // beq
            (0x4348, 0, Class::Multiply),             // muls r0, r1, r0
            (0x4801, 0, Class::Load),                 // ldr r0, [pc, #4]
            (0x5c88, 0, Class::Load),                 // ldrb r0, [r1, r2]
            (0x5088, 0, Class::Store),                // str r0, [r1, r2]
            (0x9801, 0, Class::Load),                 // ldr r0, [sp, #4]
            (0x8008, 0, Class::Store),                // strh r0, [r1]
            (0xb5f0, 0, Class::StoreMany(5)),         // push {r4-r7, lr}
            (0xbdf0, 0, Class::LoadMany(5)),          // pop {r4-r7, pc}
            (0xc80e, 0, Class::LoadMany(3)),          // ldm r0!, {r1-r3}
            (0xe92d, 0x4ff0, Class::StoreMany(9)),    // push.w {r4-r11, lr}
            (0xe9d0, 0x1200, Class::LoadMany(2)),     // ldrd r1, r2, [r0]
            (0xf8d0, 0x1004, Class::Load),            // ldr.w r1, [r0, #4]
            (0xf8c0, 0x1004, Class::Store),           // str.w r1, [r0, #4]
            (0xf000, 0xf801, Class::Call),            // bl
            (0xf04f, 0x30ff, Class::Simple),          // mov.w r0, #-1
            (0xfb00, 0xf101, Class::Multiply),        // mul r1, r0, r1
            (0xfb00, 0x2101, Class::MultiplyAdd),     // mla r1, r0, r1, r2
            (0xfba0, 0x0101, Class::LongMultiply),    // umull r0, r1, r0, r1
            (0xfbc1, 0x2300, Class::LongMultiplyAdd), // smlal r2, r3, r1, r0
            (0xfbb0, 0xf0f1, Class::Divide),          // udiv r0, r0, r1
        ] {
            assert_eq!(
                super::class(first, second),
                class,
                "{first:04x} {second:04x}"
            );
        }
    }
}
