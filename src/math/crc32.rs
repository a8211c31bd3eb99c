use crate::math::Color;

/// CRC-32 (IEEE 802.3) of what it is fed: of compiled scenes, and of pictures
/// that must be the same on every target.
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
    /// Nothing fed yet.
    pub const fn new() -> Self {
        Self(u32::MAX)
    }

    /// Feeds bytes.
    #[inline(never)]
    pub fn update(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = shifted(self.0 ^ u32::from(*byte));
        }
    }

    /// Feeds a pixel: red, green and blue as big-endian words, as a 16-bit
    /// PNG keeps them.
    pub fn update_pixel(&mut self, Color { r, g, b }: Color<u16>) {
        for channel in [r, g, b] {
            self.update(&channel.to_be_bytes());
        }
    }

    /// The checksum of all that was fed.
    pub const fn finish(self) -> u32 {
        !self.0
    }
}

/// The register, eight bits on.
///
/// By four bits at once: a table for eight would take 1 KB. Not inlined, as loops around it
/// would be unrolled, far from anything hot.
#[inline(never)]
fn shifted(register: u32) -> u32 {
    (0..2).fold(register, |register, _| {
        (register >> 4) ^ FOUR_BITS[(register & 15) as usize]
    })
}

/// What the four bits that leave the register do to the others.
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
