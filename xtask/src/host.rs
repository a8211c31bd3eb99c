//! Renders and decodes scenes on the host. Tests compare the results with those of firmware.

use std::path::Path;

use anyhow::{Result, bail};
use embedded_graphics_core::geometry::Size;
use whitted::SceneBuffer;
use whitted_sim::{render, scene_file};

/// Renders a scene on the host. Returns the checksum of the picture in the format that firmware
/// prints.
pub fn checksum(scene: &Path, size: Size) -> Result<String> {
    let file = scene_file::load(scene)?;
    let mut buffer = Box::new(scene_file::Buffer::new());
    let picture = render::linear(&file.prepare(&mut buffer)?, size);
    Ok(format!("{:08x}", render::checksum(&picture)))
}

/// Returns the message of the error that firmware finds when it decodes an invalid compiled scene.
/// Like the firmware, this function has capacity for 64 objects, 8 lights and 64 materials.
pub fn decode_error(compiled: &[u8]) -> Result<String> {
    let mut buffer = Box::new(SceneBuffer::<64, 8, 64>::new());
    match buffer.decode(compiled) {
        Ok(_) => bail!("the scene has no error"),
        Err(error) => Ok(error.to_string()),
    }
}
