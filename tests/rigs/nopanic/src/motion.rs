//! Calls every animation function.

use core::hint::black_box;

use whitted::animation::{AnimatedScene, Animation, Interpolation, Keyframe, Target, Track};
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

pub(crate) fn play() {
    let (scene, animation) = (black_box(&SCENE), black_box(&ANIMATION));
    if let Err(error) = animation.check(scene) {
        text::print(&error);
    }
    black_box(animation.camera(scene.camera, number()).is_ok());

    let mut animated = AnimatedScene::<2, 1>::new();
    let mut buffer = Buffer::new();
    match animated.frame(scene, animation, number()) {
        Ok(frame) => match buffer.prepare(&frame) {
            Ok(scene) => displays::draw_on_all(black_box(&scene)),
            Err(error) => text::print(&error),
        },
        Err(error) => text::print(&error),
    }
}
