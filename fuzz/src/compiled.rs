use whitted::SceneBuffer;
use whitted::codec::Crc32;

use super::picture::draw;

type Buffer = SceneBuffer<16, 4, 16>;

/// Checks that any bytes decode to a scene that can be drawn, or to an error.
///
/// The input is decoded as is, and with a valid checksum appended. Returns true if one of
/// the two is a scene.
pub fn compiled(input: &[u8]) -> bool {
    let is_scene = decode(input);
    let mut with_checksum = input.to_vec();
    let mut crc = Crc32::new();
    crc.update(input);
    with_checksum.extend(crc.finish().to_le_bytes());
    decode(&with_checksum) | is_scene
}

/// Decodes and draws a scene. Returns true if the bytes are a scene.
fn decode(bytes: &[u8]) -> bool {
    let mut buffer = Box::new(Buffer::new());
    match buffer.decode(bytes) {
        Ok(scene) => {
            let mut encoded = vec![0; scene.encoded_len()];
            assert_eq!(scene.encode(&mut encoded), Some(encoded.len()));
            _ = draw(&scene);
            true
        }
        Err(error) => error.to_string().is_empty(),
    }
}
