//! A small picture that `cargo xtask prove` also draws in Miri, as on a machine
//! of the other byte order.

use embedded_graphics_core::geometry::Size;
use whitted::SceneBuffer;
use whitted_sim::{render, scene_file};

const SCENE: &str = include_str!("../scenes/every_surface.toml");
const SIZE: Size = Size::new(4, 3);
const CHECKSUM: u32 = 0x2930_e00a;

#[test]
fn a_compiled_scene_is_the_same_everywhere() -> Result<(), Box<dyn std::error::Error>> {
    let file = scene_file::parse("every_surface.toml", SCENE)?;
    // No larger than it needs to be: in Miri every byte takes its time.
    let mut buffer = SceneBuffer::<24, 3, 12>::new();
    let scene = buffer.prepare(&file.scene())?;
    let mut bytes = vec![0; scene.encoded_len()];
    assert_eq!(scene.encode(&mut bytes), Some(bytes.len()));
    let mut buffer = SceneBuffer::<24, 3, 12>::new();
    let decoded = buffer.decode(&bytes)?;
    let checksum = render::checksum(&render::linear(&decoded, SIZE));
    assert_eq!(checksum, CHECKSUM, "{checksum:#x}");
    Ok(())
}
