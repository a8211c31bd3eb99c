//! Compiles a scene to bytes on the host. Firmware decodes the bytes and draws the scene.
//!
//! `cargo run --example compiled_scene` writes `compiled_scene.png`. For scene files,
//! `cargo sim compile` writes the bytes to a file, and firmware embeds the file with
//! `include_bytes!`.

pub(crate) mod common;

use std::error::Error;

use common::Display;
use common::scene::{Buffer, SCENE, SIZE};
use whitted::{Renderer, SceneError};

/// Prepares the scene and encodes it. This part runs on the host.
pub(crate) fn compile() -> Result<Vec<u8>, SceneError> {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE)?;
    let mut bytes = vec![0; scene.encoded_len()];
    // `encode` returns `None` only if the slice is shorter than `encoded_len`.
    let length = scene.encode(&mut bytes).unwrap_or(0);
    bytes.truncate(length);
    Ok(bytes)
}

/// Decodes the scene and draws it. This part runs in firmware.
///
/// `decode` checks the CRC-32 and all values. It returns an error if the bytes are corrupt,
/// for example after a bad transfer.
pub(crate) fn draw(bytes: &[u8]) -> Result<Display, Box<dyn Error>> {
    let mut buffer = Buffer::new();
    let scene = buffer.decode(bytes)?;
    let mut display = Display::new(SIZE);
    Renderer::new(&scene, SIZE).draw(&mut display)?;
    Ok(display)
}

fn main() -> Result<(), Box<dyn Error>> {
    let bytes = compile()?;
    println!("the compiled scene takes {} bytes", bytes.len());
    common::save("compiled_scene.png", 2, &[draw(&bytes)?])
}
