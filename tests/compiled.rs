//! Compiled scenes: they draw the picture of their source, and the decoder rejects
//! damaged bytes.

use std::fs;

use embedded_graphics::geometry::Size;
use whitted::codec::Crc32;
use whitted::scene::SceneItem;
use whitted::{DecodeError, PreparedScene, SceneBuffer};
use whitted_sim::{render, scene_file};

/// Compiles a scene of the folder `tests/scenes`.
fn compiled(name: &str) -> Vec<u8> {
    scene_file::compile(format!(
        "{}/tests/scenes/{name}.toml",
        env!("CARGO_MANIFEST_DIR")
    ))
    .unwrap()
}

fn checksum(scene: &PreparedScene<'_>) -> u32 {
    render::checksum(&render::linear(scene, Size::new(64, 48)))
}

#[test]
fn decoded_scene_draws_same_picture() {
    for entry in fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/scenes")).unwrap() {
        let path = entry.unwrap().path();
        let file = scene_file::load(&path).unwrap();
        let mut buffer = Box::new(scene_file::Buffer::new());
        let scene = file.prepare(&mut buffer).unwrap();
        let mut other = Box::new(scene_file::Buffer::new());
        let bytes = scene_file::compile(&path).unwrap();
        if file.animation.is_none() {
            assert_eq!(bytes.len(), scene.encoded_len());
        }
        let decoded = other.decode(&bytes).unwrap();
        assert_eq!(checksum(&scene), checksum(&decoded), "{}", path.display());
    }
}

/// Compiles every scene of the folder `tests/scenes`.
fn all_compiled() -> impl Iterator<Item = Vec<u8>> {
    let scenes = fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/scenes")).unwrap();
    scenes.map(|entry| scene_file::compile(entry.unwrap().path()).unwrap())
}

#[test]
fn rejects_every_bit_flip() {
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut flips = 0;
    for mut bytes in all_compiled() {
        for bit in 0..bytes.len() * 8 {
            bytes[bit / 8] ^= 1 << (bit % 8);
            assert!(buffer.decode(&bytes).is_err(), "bit {bit}");
            assert!(buffer.decode_animation(&bytes).is_err(), "bit {bit}");
            bytes[bit / 8] ^= 1 << (bit % 8);
            flips += 1;
        }
        assert!(buffer.decode(&bytes).is_ok());
    }
    println!("figure: {flips} flipped bits refused");
}

#[test]
fn rejects_every_truncation_and_extension() {
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut truncations = 0;
    for bytes in all_compiled() {
        for length in 0..bytes.len() {
            assert!(buffer.decode(&bytes[..length]).is_err(), "{length}");
            truncations += 1;
        }
        let mut longer = bytes.clone();
        longer.push(0);
        assert!(buffer.decode(&longer).is_err());
    }
    println!("figure: {truncations} truncations refused");
    assert_eq!(
        buffer.decode(b"[camera]").unwrap_err(),
        DecodeError::NotAScene
    );
}

/// Replaces the trailing checksum of changed bytes by a correct one.
fn resealed(mut bytes: Vec<u8>) -> Vec<u8> {
    let body = bytes.len() - 4;
    let mut crc = Crc32::new();
    crc.update(&bytes[..body]);
    bytes[body..].copy_from_slice(&crc.finish().to_le_bytes());
    bytes
}

#[test]
fn rejects_other_versions_and_invalid_values() {
    let mut buffer = SceneBuffer::<16, 4, 16>::new();
    let mut newer = compiled("whitted");
    newer[4] += 1;
    let version = newer[4];
    assert_eq!(
        buffer.decode(&resealed(newer)).unwrap_err(),
        DecodeError::Version {
            found: version,
            expected: version - 1
        }
    );

    let mut far_eye = compiled("whitted");
    // Magic, version and three counts take 11 bytes; 3 bytes after them is the high
    // byte of the eye's x.
    far_eye[11 + 3] = 0x7f;
    assert_eq!(
        buffer.decode(&resealed(far_eye)).unwrap_err(),
        DecodeError::Invalid(SceneItem::Scene)
    );
}

/// Flips every bit of a compiled animation and corrects the checksum. Each changed animation must
/// be rejected, or its frames must be valid scenes.
#[test]
fn frames_of_changed_animations_are_valid() {
    let mut buffer = Box::new(SceneBuffer::<4, 1, 4>::new());
    let mut other = Box::new(SceneBuffer::<4, 1, 4>::new());
    let original = compiled("bouncing_ball");
    let (mut refused, mut played) = (0, 0);
    for bit in 0..original.len() * 8 - 32 {
        let mut bytes = original.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        let bytes = resealed(bytes);
        let Ok(mut animation) = buffer.decode_animation(&bytes) else {
            refused += 1;
            continue;
        };
        played += 1;
        for time in ["0", "0.7", "1.001", "1.9"] {
            // At some times, the camera may have no direction.
            let Ok(frame) = animation.frame(time.parse().unwrap()) else {
                continue;
            };
            let mut scene = vec![0; frame.encoded_len()];
            frame.encode(&mut scene).unwrap();
            other.decode(&scene).unwrap();
        }
    }
    println!("figure: {refused} changed animations refused, {played} played");
    assert!(refused > 1000 && played > 1000, "{refused}, {played}");
}

#[test]
fn rejects_damaged_animations() {
    let mut buffer = Box::new(SceneBuffer::<4, 1, 4>::new());
    let original = compiled("bouncing_ball");
    let body = original.len() - 4;
    let with_body = |body: &[u8]| resealed([body, &[0; 4]].concat());
    let length = Err(DecodeError::Length);
    for shorter in [1, 8, 32, 300] {
        let bytes = with_body(&original[..body - shorter]);
        assert_eq!(buffer.decode_animation(&bytes).map(drop), length);
    }
    let longer = with_body(&[&original[..body], &[0]].concat());
    assert_eq!(buffer.decode_animation(&longer).map(drop), length);
    // Bytes after the objects must begin with the tag of an animation.
    let still = compiled("whitted");
    let longer = with_body(&[&still[..still.len() - 4], b"B"].concat());
    assert_eq!(buffer.decode(&longer).map(drop), length);
}

#[test]
fn scene_without_animation_has_equal_frames() {
    let bytes = compiled("whitted");
    let mut buffer = SceneBuffer::<16, 4, 16>::new();
    let mut animation = buffer.decode_animation(&bytes).unwrap();
    assert!(!animation.is_animated());
    for time in ["0", "-1", "1.5"] {
        let mut encoded = vec![0; bytes.len()];
        let frame = animation.frame(time.parse().unwrap()).unwrap();
        assert_eq!(frame.encode(&mut encoded), Some(bytes.len()));
        assert_eq!(encoded, bytes);
    }
    let mut encoded = vec![0; animation.encoded_len()];
    assert_eq!(animation.encode(&mut encoded), Some(bytes.len()));
    assert_eq!(encoded, bytes);
}

#[test]
fn rejects_scene_larger_than_buffer() {
    let mut buffer = SceneBuffer::<2, 4, 16>::new();
    let error = buffer.decode(&compiled("whitted")).unwrap_err();
    assert_eq!(error.to_string(), "too many objects: the buffer holds 2");
}

#[test]
fn encode_rejects_short_slice() {
    let mut buffer = SceneBuffer::<16, 4, 16>::new();
    let bytes = compiled("whitted");
    let scene = buffer.decode(&bytes).unwrap();
    assert_eq!(scene.encode(&mut vec![0; bytes.len() - 1]), None);
    let mut out = vec![0; bytes.len() + 5];
    assert_eq!(scene.encode(&mut out), Some(bytes.len()));
    assert_eq!(out[..bytes.len()], bytes);
}
