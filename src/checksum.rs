use crate::Color;

/// CRC-32 (IEEE 802.3) of what it is fed: of compiled scenes, and of pictures
/// that must be the same on every target.
///
/// ```
/// use whitted::Crc32;
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
            self.0 ^= u32::from(*byte);
            for _ in 0..8 {
                // Without a table: it is far from any hot loop.
                self.0 = (self.0 >> 1) ^ (0xedb8_8320 & (self.0 & 1).wrapping_neg());
            }
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

impl Default for Crc32 {
    fn default() -> Self {
        Self::new()
    }
}
