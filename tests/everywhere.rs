//! Small pictures with known checksums, which `cargo xtask prove` also draws in
//! Miri on an emulated big-endian machine. Scenes are compiled in, because parsing
//! a scene file in Miri takes longer than drawing.

use std::path::Path;

use embedded_graphics::prelude::Size;
use whitted::codec::Crc32;
use whitted::{PreparedScene, SceneBuffer, real};
use whitted_sim::render;

#[path = "../tests/rigs/motion/src/scene.rs"]
#[allow(dead_code, reason = "only firmware uses its frame times and size")]
mod moving;

/// Compiled form of tests/scenes/every_surface.toml.
const COMPILED: &[u8] = include_bytes!("../fuzz/corpus/compiled/every_surface_sealed");

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn checksum(scene: &PreparedScene<'_>) -> u32 {
    render::checksum(&render::linear(scene, Size::new(4, 3)))
}

#[test]
fn compiled_scene_checksum() -> Outcome {
    let mut buffer = SceneBuffer::<24, 3, 12>::new();
    let scene = buffer.decode(COMPILED)?;
    let mut bytes = vec![0; scene.encoded_len()];
    assert_eq!(scene.encode(&mut bytes), Some(bytes.len()));
    assert_eq!(bytes, COMPILED);
    let checksum = checksum(&scene);
    assert_eq!(checksum, 0x1210_93aa, "{checksum:#x}");
    Ok(())
}

#[test]
fn animation_frame_checksum() -> Outcome {
    let mut buffer = SceneBuffer::<5, 1, 5>::new();
    let mut animation = buffer.prepare_animation(&moving::SCENE, &moving::ANIMATION)?;
    let scene = animation.frame(real!(0.7))?;
    let mut bytes = vec![0; scene.encoded_len()];
    assert_eq!(scene.encode(&mut bytes), Some(bytes.len()));
    let mut crc = Crc32::new();
    // The trailing checksum is left out: with it, the CRC of any valid scene is
    // the same constant.
    crc.update(&bytes[..bytes.len() - 4]);
    let (compiled, drawn) = (crc.finish(), checksum(&scene));
    assert_eq!(compiled, 0x973e_5a2c, "{compiled:#x}");
    assert_eq!(drawn, 0x0fb4_098e, "{drawn:#x}");
    Ok(())
}

#[test]
#[cfg_attr(miri, ignore = "reads a scene file")]
fn compiled_scene_matches_scene_file() -> Outcome {
    let scene = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/scenes/every_surface.toml"
    );
    assert_eq!(
        whitted_sim::scene_file::compile(Path::new(scene))?,
        COMPILED
    );
    Ok(())
}
