//! A scene compiled on the host to bytes, which firmware decodes and draws.
//!
//! `cargo run --example compiled_scene` writes `compiled_scene.png`. For scene files,
//! `cargo sim compile` writes the bytes, and firmware takes them in by `include_bytes!`.

pub(crate) mod common;

use std::error::Error;

use common::Display;
use common::scene::{Buffer, SCENE, SIZE};
use whitted::{Renderer, SceneError};

/// Runs on the host: prepares the scene and encodes it.
pub(crate) fn compile() -> Result<Vec<u8>, SceneError> {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE)?;
    let mut bytes = vec![0; scene.encoded_len()];
    // `encode` returns `None` only if the slice is shorter than `encoded_len`.
    let length = scene.encode(&mut bytes).unwrap_or(0);
    bytes.truncate(length);
    Ok(bytes)
}

/// Runs in firmware: decodes the scene and draws it.
///
/// `decode` checks the CRC-32 and all values, so bytes from a serial port may be corrupt.
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
