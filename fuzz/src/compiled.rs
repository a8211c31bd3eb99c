use whitted::SceneBuffer;
use whitted::codec::Crc32;

use super::picture::draw;

type Buffer = SceneBuffer<16, 4, 16>;

/// Any bytes are a scene that can be drawn, or an error; with a right checksum
/// put behind them, too. Says whether either is a scene.
pub fn compiled(input: &[u8]) -> bool {
    let is_scene = decode(input);
    let mut sealed = input.to_vec();
    let mut crc = Crc32::new();
    crc.update(input);
    sealed.extend(crc.finish().to_le_bytes());
    decode(&sealed) | is_scene
}

fn decode(bytes: &[u8]) -> bool {
    let mut buffer = Box::new(Buffer::new());
    match buffer.decode(bytes) {
        Ok(scene) => {
            let mut again = vec![0; scene.encoded_len()];
            assert_eq!(scene.encode(&mut again), Some(again.len()));
            _ = draw(&scene);
            true
        }
        Err(error) => error.to_string().is_empty(),
    }
}
