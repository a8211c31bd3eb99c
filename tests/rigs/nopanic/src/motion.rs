//! Calls every animation function.

use core::hint::black_box;

use whitted::animation::{Animation, Interpolation, Keyframe, PreparedAnimation, Target, Track};
use whitted::{Real, real, vec3};

use crate::scenes::{Buffer, SCENE, number};
use crate::{displays, text};

/// Animation that is passed by reference through `black_box`, which hides its content from
/// the compiler.
static ANIMATION: Animation = Animation {
    duration: Real::ZERO,
    looping: true,
    tracks: &[Track {
        target: Target::CameraOrbit,
        interpolation: Interpolation::Smooth,
        keys: &[
            Keyframe::number(real!(0), real!(0)),
            Keyframe::angles(real!(0), real!(0), real!(0)),
            Keyframe::vector(real!(0), vec3!(0, 0, 0)),
        ],
    }],
};

/// Prepares, compiles, decodes and plays an animation.
pub(crate) fn play() {
    let (scene, animation) = (black_box(&SCENE), black_box(&ANIMATION));
    if let Err(error) = animation.check(scene) {
        text::print(&error);
    }
    let mut buffer = Buffer::new();
    match buffer.prepare_animation(scene, animation) {
        Ok(mut animation) => {
            let mut bytes = [0; 64];
            let out: &mut [u8] = black_box(&mut bytes);
            black_box((animation.encoded_len(), animation.encode(out)));
            draw(&mut animation);
        }
        Err(error) => text::print(&error),
    }
    let bytes: &[u8] = black_box(&[]);
    match buffer.decode_animation(bytes) {
        Ok(mut animation) => draw(&mut animation),
        Err(error) => text::print(&error),
    }
}

fn draw(animation: &mut PreparedAnimation<'_>) {
    black_box((
        animation.is_animated(),
        animation.is_looping(),
        animation.duration(),
    ));
    black_box(animation.counts());
    match animation.frame(number()) {
        Ok(scene) => displays::draw_on_all(black_box(&scene)),
        Err(error) => text::print(&error),
    }
}
