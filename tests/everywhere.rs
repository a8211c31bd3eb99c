//! Small pictures that `cargo xtask prove` also draws in Miri, as on a machine of
//! the other byte order. Nothing is read from scene files: in Miri that takes
//! longer than all else.

use std::path::Path;

use embedded_graphics::prelude::Size;
use whitted::animation::AnimatedScene;
use whitted::codec::Crc32;
use whitted::{PreparedScene, Real, SceneBuffer};
use whitted_sim::render;

#[path = "../tests/rigs/motion/src/scene.rs"]
#[allow(dead_code, reason = "its times and size are those of firmware")]
mod moving;

/// scenes/every_surface.toml.
const COMPILED: &[u8] = include_bytes!("../fuzz/corpus/compiled/every_surface_sealed");

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn checksum(scene: &PreparedScene<'_>) -> u32 {
    render::checksum(&render::linear(scene, Size::new(4, 3)))
}

#[test]
fn a_compiled_scene_is_the_same_everywhere() -> Outcome {
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
fn a_frame_is_the_same_everywhere() -> Outcome {
    let mut stage = AnimatedScene::<5, 1>::new();
    let frame = stage.frame(&moving::SCENE, &moving::ANIMATION, Real::lit("0.7"))?;
    let mut buffer = SceneBuffer::<5, 1, 5>::new();
    let scene = buffer.prepare(&frame)?;
    let mut bytes = vec![0; scene.encoded_len()];
    assert_eq!(scene.encode(&mut bytes), Some(bytes.len()));
    let mut crc = Crc32::new();
    // All but the checksum at their end, with which any bytes have the same one.
    crc.update(&bytes[..bytes.len() - 4]);
    let (compiled, drawn) = (crc.finish(), checksum(&scene));
    assert_eq!(compiled, 0x796c_fad8, "{compiled:#x}");
    assert_eq!(drawn, 0x0fb4_098e, "{drawn:#x}");
    Ok(())
}

#[test]
#[cfg_attr(miri, ignore = "it reads a scene file")]
fn the_compiled_scene_is_that_of_its_file() -> Outcome {
    let scene = concat!(env!("CARGO_MANIFEST_DIR"), "/scenes/every_surface.toml");
    assert_eq!(
        whitted_sim::scene_file::compile(Path::new(scene))?,
        COMPILED
    );
    Ok(())
}
