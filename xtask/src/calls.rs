//! Which code branches to which, as far as its instructions tell.

/// The direct calls and long jumps of Thumb code at an address: from where, and to where.
///
/// Tables and constants between instructions may look like either; what they seem to call
/// is hardly ever the start of a function.
pub(crate) fn branches(code: &[u8], address: u64) -> Vec<(u64, u64)> {
    let mut halves = code
        .chunks_exact(2)
        .map(|pair| u32::from(u16::from_le_bytes([pair[0], pair[1]])))
        .zip((address..).step_by(2));
    let mut found = Vec::new();
    while let Some((first, at)) = halves.next() {
        if first >> 11 < 0b11101 {
            continue;
        }
        let Some((second, _)) = halves.next() else {
            break;
        };
        if let Some(offset) = offset(first, second) {
            found.push((at, (at + 4).wrapping_add_signed(offset.into())));
        }
    }
    found
}

/// How far `BL` and `B.W` lead, from four bytes beyond them (Armv7-M Architecture Reference
/// Manual, encodings T1 and T4).
fn offset(first: u32, second: u32) -> Option<i32> {
    if first >> 11 != 0b11110 || second & 0x9000 != 0x9000 {
        return None;
    }
    let sign = first >> 10 & 1;
    let inverted = |bit: u32| (second >> bit & 1) ^ sign ^ 1;
    let bits = sign << 24
        | inverted(13) << 23
        | inverted(11) << 22
        | (first & 0x3ff) << 12
        | (second & 0x7ff) << 1;
    // Of 25 bits, the first is the sign.
    Some((bits << 7) as i32 >> 7)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn calls_and_long_jumps_are_found() {
        // nop; bl .+0x104; movw r0, #0x1234; b.w .-0x6
        let code = [
            0x00, 0xbf, 0x00, 0xf0, 0x80, 0xf8, 0x41, 0xf2, 0x34, 0x20, 0xff, 0xf7, 0xfb, 0xbf,
        ];
        assert_eq!(branches(&code, 0x100), [(0x102, 0x206), (0x10a, 0x104)],);
    }
}
