use cobs::CobsEncoder;
use whitted::codec::Crc32;

/// Size of the ticket and the checksum in a frame, in bytes.
pub(crate) const OVERHEAD: usize = size_of::<u16>() + size_of::<u32>();

/// Returns the largest possible size of an encoded serial frame with a scene of `scene_len` bytes.
/// Both sizes are in bytes.
pub const fn frame_len(scene_len: usize) -> usize {
    const DELIMITERS: usize = 2;
    DELIMITERS + cobs::max_encoding_length(scene_len + OVERHEAD)
}

/// Encodes a scene as a frame in `buffer` and returns the frame.
///
/// Returns `None` if `buffer` is shorter than the size that [`frame_len`] returns.
pub fn frame<'f>(ticket: u16, scene: &[u8], buffer: &'f mut [u8]) -> Option<&'f [u8]> {
    let buffer = buffer.get_mut(..frame_len(scene.len()))?;
    let ticket = ticket.to_le_bytes();
    let checksum = checksum(&[&ticket, scene]).to_le_bytes();

    *buffer.first_mut()? = 0;
    let mut encoder = CobsEncoder::new(buffer.get_mut(1..)?);
    for part in [&ticket[..], scene, &checksum] {
        encoder.push(part).ok()?;
    }
    let end = 1 + encoder.finalize();
    *buffer.get_mut(end)? = 0;
    buffer.get(..=end)
}

/// Returns the CRC-32 of the concatenated parts.
pub(crate) fn checksum(parts: &[&[u8]]) -> u32 {
    let mut crc = Crc32::new();
    parts.iter().for_each(|part| crc.update(part));
    crc.finish()
}
