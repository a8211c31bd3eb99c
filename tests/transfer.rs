//! The transfer function of a scene: renderers start with it, and compiled scenes keep it.

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use whitted::animation::Animation;
use whitted::codec::Crc32;
use whitted::render::{AaSample, AntialiasedRenderer, Output, SampleCount};
use whitted::scene::{SceneItem, Transfer};
use whitted::{
    Background, Camera, Color, DecodeError, PreparedScene, Real, Renderer, Scene, SceneBuffer, vec3,
};

type Buffer = SceneBuffer<1, 1, 1>;
type Outcome = Result<(), Box<dyn std::error::Error>>;

/// Background that sRGB displays show as (192, 64, 32).
const BACKGROUND: Background = Background::Solid(Color::srgb(0xc0, 0x40, 0x20));

fn scene(transfer: Transfer) -> Scene<'static> {
    let camera = Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), Real::ONE);
    Scene {
        background: BACKGROUND,
        transfer,
        ..Scene::new(camera)
    }
}

fn encoded(scene: &PreparedScene<'_>) -> Vec<u8> {
    let mut bytes = vec![0; scene.encoded_len()];
    assert_eq!(scene.encode(&mut bytes), Some(bytes.len()));
    bytes
}

/// Draws a pixel with and without antialiasing, and returns its color.
fn drawn(scene: &PreparedScene<'_>) -> Result<Rgb888, Box<dyn std::error::Error>> {
    let size = Size::new(1, 1);
    let mut memory = [AaSample::BLACK; 2];
    let mut pixel = [[Rgb888::BLACK]; 2];
    Renderer::new(scene, size).render_line(0, &mut pixel[0]);
    AntialiasedRenderer::new(scene, size, SampleCount::Four, &mut memory)?
        .render_line(0, &mut pixel[1]);
    assert_eq!(pixel[0], pixel[1]);
    Ok(pixel[0][0])
}

#[test]
fn renderers_start_with_the_transfer_of_the_scene() -> Outcome {
    let shown = [
        (Transfer::Linear, Rgb888::new(134, 13, 4)),
        (Transfer::Srgb, Rgb888::new(0xc0, 0x40, 0x20)),
    ];
    for (transfer, expected) in shown {
        let (mut buffer, mut other) = (Buffer::new(), Buffer::new());
        let scene = scene(transfer);
        let prepared = buffer.prepare(&scene)?;
        assert_eq!(drawn(&prepared)?, expected);
        let bytes = encoded(&prepared);
        let decoded = other.decode(&bytes)?;
        assert_eq!(decoded.transfer(), transfer);
        assert_eq!(drawn(&decoded)?, expected);
    }
    Ok(())
}

#[test]
fn output_of_a_renderer_overrides_the_scene() -> Outcome {
    let mut buffer = Buffer::new();
    let prepared = buffer.prepare(&scene(Transfer::Srgb))?;
    let mut renderer = Renderer::new(&prepared, Size::new(1, 1));
    assert_eq!(renderer.output().transfer, Transfer::Srgb);
    renderer.set_output(Output::default());
    let mut pixel = [Rgb888::BLACK];
    renderer.render_line(0, &mut pixel);
    assert_eq!(pixel, [Rgb888::new(134, 13, 4)]);
    Ok(())
}

#[test]
fn frames_of_an_animation_keep_the_transfer() -> Outcome {
    let animation = Animation {
        duration: Real::ONE,
        looping: true,
        tracks: &[],
    };
    let (mut buffer, mut other) = (Buffer::new(), Buffer::new());
    let scene = scene(Transfer::Srgb);
    let mut prepared = buffer.prepare_animation(&scene, &animation)?;
    assert_eq!(
        drawn(&prepared.frame(Real::ZERO)?)?,
        Rgb888::new(0xc0, 0x40, 0x20)
    );
    let mut bytes = vec![0; prepared.encoded_len()];
    assert_eq!(prepared.encode(&mut bytes), Some(bytes.len()));
    let mut decoded = other.decode_animation(&bytes)?;
    assert_eq!(decoded.frame(Real::ZERO)?.transfer(), Transfer::Srgb);
    Ok(())
}

#[test]
fn decoding_rejects_an_unknown_transfer() -> Outcome {
    let (mut buffer, mut other) = (Buffer::new(), Buffer::new());
    let [linear, srgb] = {
        let linear = encoded(&buffer.prepare(&scene(Transfer::Linear))?);
        [linear, encoded(&buffer.prepare(&scene(Transfer::Srgb))?)]
    };
    let body = linear.len() - 4;
    let differing: Vec<_> = (0..body).filter(|at| linear[*at] != srgb[*at]).collect();
    let [at] = differing[..] else {
        return Err(format!("{differing:?}").into());
    };
    let mut unknown = srgb;
    unknown[at] = 2;
    let mut crc = Crc32::new();
    crc.update(&unknown[..body]);
    unknown[body..].copy_from_slice(&crc.finish().to_le_bytes());
    let error = other.decode(&unknown).err();
    assert_eq!(error, Some(DecodeError::Invalid(SceneItem::Scene)));
    Ok(())
}
