use super::color::Color;

/// Computes a CRC-32 (IEEE 802.3) of bytes or pixels.
///
/// The last bytes of a compiled scene are its CRC-32. Tests also use the CRC-32 to compare the
/// pictures that different targets render.
///
/// ```
/// use whitted::codec::Crc32;
///
/// let mut crc = Crc32::new();
/// crc.update(b"123456789");
/// assert_eq!(crc.finish(), 0xcbf4_3926);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Crc32(u32);

impl Crc32 {
    /// Starts a checksum to which no bytes have been added.
    pub const fn new() -> Self {
        Self(u32::MAX)
    }

    /// Adds bytes to the checksum.
    #[inline(never)]
    pub fn update(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = shifted(self.0 ^ u32::from(*byte));
        }
    }

    /// Adds a pixel to the checksum: red, green and blue as big-endian 16-bit words, as in a 16-bit
    /// PNG.
    pub fn update_pixel(&mut self, Color { r, g, b }: Color<u16>) {
        for channel in [r, g, b] {
            self.update(&channel.to_be_bytes());
        }
    }

    /// Returns the checksum of all bytes added so far.
    pub const fn finish(self) -> u32 {
        !self.0
    }
}

/// Advances the CRC register by eight bits, four bits at a time.
///
/// The table for four bits takes 64 bytes of flash. A table for eight bits would take 1 KB. The
/// function is not inlined. Otherwise, the compiler would unroll the loops of all callers, which
/// takes more flash.
#[inline(never)]
fn shifted(register: u32) -> u32 {
    (0..2).fold(register, |register, _| {
        (register >> 4) ^ FOUR_BITS[(register & 15) as usize]
    })
}

/// For each value of four bits, the word to XOR into the CRC register when these bits are shifted
/// out.
static FOUR_BITS: [u32; 16] = {
    let mut table = [0; 16];
    let mut bits = 0;
    while bits < table.len() {
        let mut register = bits as u32;
        let mut shifts = 0;
        while shifts < 4 {
            register = (register >> 1) ^ (0xedb8_8320 & (register & 1).wrapping_neg());
            shifts += 1;
        }
        table[bits] = register;
        bits += 1;
    }
    table
};

impl Default for Crc32 {
    fn default() -> Self {
        Self::new()
    }
}
