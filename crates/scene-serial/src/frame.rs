use cobs::CobsEncoder;
use whitted::codec::Crc32;

/// What a frame has beside the scene: the ticket and the checksum.
pub(crate) const EXTRA: usize = size_of::<u16>() + size_of::<u32>();

/// How many bytes a frame needs at most, with a scene of so many.
pub const fn frame_len(scene: usize) -> usize {
    const SENTINELS: usize = 2;
    SENTINELS + cobs::max_encoding_length(scene + EXTRA)
}

/// Writes the frame of a scene, and returns it; nothing if there is no room for
/// [`frame_len`] bytes.
pub fn frame<'f>(ticket: u16, scene: &[u8], room: &'f mut [u8]) -> Option<&'f [u8]> {
    let room = room.get_mut(..frame_len(scene.len()))?;
    let ticket = ticket.to_le_bytes();
    let checksum = checksum(&[&ticket, scene]).to_le_bytes();

    *room.first_mut()? = 0;
    let mut encoder = CobsEncoder::new(room.get_mut(1..)?);
    for part in [&ticket[..], scene, &checksum] {
        encoder.push(part).ok()?;
    }
    let end = 1 + encoder.finalize();
    *room.get_mut(end)? = 0;
    room.get(..=end)
}

pub(crate) fn checksum(parts: &[&[u8]]) -> u32 {
    let mut crc = Crc32::new();
    parts.iter().for_each(|part| crc.update(part));
    crc.finish()
}
