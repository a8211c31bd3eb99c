//! Mutations of compiled scenes, PNGs and serial transfers.

use fastrand::Rng;
use scene_serial::{frame, frame_len};
use whitted::codec::Crc32;

/// Replaces, inserts or removes one to four bytes, or cuts the end.
pub(crate) fn replace_bytes(rng: &mut Rng, bytes: &mut Vec<u8>) {
    for _ in 0..rng.u8(1..=4) {
        if bytes.is_empty() {
            return;
        }
        let place = rng.usize(..bytes.len());
        let byte = rng
            .choice([0, 1, 0x7f, 0x80, 0xff, rng.clone().u8(..)])
            .unwrap_or_default();
        match rng.u8(..8) {
            0..5 => {
                if let Some(old) = bytes.get_mut(place) {
                    *old = byte;
                }
            }
            5 => bytes.insert(place, byte),
            6 => drop(bytes.remove(place)),
            _ => bytes.truncate(place),
        }
    }
}

/// Returns a mutated compiled scene. Half of them have a valid checksum.
pub(crate) fn mutated_scene(rng: &mut Rng, scenes: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = rng.choice(scenes).cloned().unwrap_or_default();
    replace_bytes(rng, &mut bytes);
    if rng.bool()
        && let Some((body, _)) = bytes.split_last_chunk::<4>()
    {
        let mut crc = Crc32::new();
        crc.update(body);
        bytes = [body, &crc.finish().to_le_bytes()].concat();
    }
    bytes
}

/// Returns a mutated PNG. Three of four have valid checksums.
pub(crate) fn mutated_png(rng: &mut Rng, pictures: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = rng.choice(pictures).cloned().unwrap_or_default();
    match rng.bool() {
        // The header: width, height, depth, color type, compression, filter, interlacing.
        true => {
            let place = rng.usize(16..29);
            if let Some(byte) = bytes.get_mut(place) {
                *byte = rng
                    .choice([0, 1, 2, 3, 4, 6, 8, 16, 0x7f, 0xff])
                    .unwrap_or_default();
            }
        }
        false => replace_bytes(rng, &mut bytes),
    }
    if rng.u8(..4) > 0 {
        seal_chunks(&mut bytes);
    }
    bytes
}

/// Sets the checksums of the chunks of a PNG.
fn seal_chunks(bytes: &mut [u8]) {
    let mut rest = bytes.get_mut(8..).unwrap_or_default();
    while let Some((length, chunk)) = rest.split_first_chunk_mut::<4>() {
        let length = u32::from_be_bytes(*length) as usize;
        let Some((typed, after)) = chunk.split_at_mut_checked(length.saturating_add(4)) else {
            return;
        };
        let Some((checksum, after)) = after.split_first_chunk_mut::<4>() else {
            return;
        };
        let mut crc = Crc32::new();
        crc.update(typed);
        *checksum = crc.finish().to_be_bytes();
        rest = after;
    }
}

/// Returns a transfer of a mutated scene, which is mutated again half of the time.
pub(crate) fn mutated_transfer(rng: &mut Rng, scenes: &[Vec<u8>]) -> Vec<u8> {
    let scene = mutated_scene(rng, scenes);
    let mut buffer = vec![0; frame_len(scene.len())];
    let mut bytes = frame(7, &scene, &mut buffer).unwrap_or_default().to_vec();
    if rng.bool() {
        replace_bytes(rng, &mut bytes);
    }
    bytes
}
