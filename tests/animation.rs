//! Keyframe animation: interpolation, loops, targets and rejected animations.

use whitted::animation::{
    AnimatedScene, Animation, AnimationError, AnimationProblem, Interpolation, Keyframe, Target,
    Track,
};
use whitted::{
    Camera, Color, Light, MaterialId, Object, Real, Scene, Shape, Texture, Vec3, color, real, vec3,
};

use Interpolation::{Linear, Smooth};

const CAMERA: Camera = Camera::new(vec3!(0, 1, 8), vec3!(0, 1, 0), real!(33));
const BALL: Object = Object::sphere(vec3!(0, 1, 0), Real::ONE, MaterialId(0));
const FLOOR: Object = Object::floor(Real::ZERO, Texture::Uniform(MaterialId(0)));
const LAMP: Light = Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE));

const SCENE: Scene<'static> = Scene {
    lights: &[LAMP],
    objects: &[FLOOR, BALL],
    ..Scene::new(CAMERA)
};

/// Interpolates a track at a time, in an animation of 8 seconds. The field of view
/// is the target because interpolation does not check its range.
fn value(keys: &[Keyframe], interpolation: Interpolation, looping: bool, time: &str) -> Real {
    let tracks = [Track {
        target: Target::CameraFovy,
        interpolation,
        keys,
    }];
    let animation = Animation {
        duration: real!(8),
        looping,
        tracks: &tracks,
    };
    let time = time.parse().unwrap();
    animation.camera(CAMERA, time).unwrap().fovy_deg
}

#[track_caller]
fn assert_near(a: Real, b: &str) {
    let b: Real = b.parse().unwrap();
    assert!((a - b).abs() < real!(0.00000001), "{a}, not {b}");
}

const RAMP: [Keyframe; 3] = [
    Keyframe::number(real!(1), real!(10)),
    Keyframe::number(real!(3), real!(20)),
    Keyframe::number(real!(7), real!(-20)),
];

#[test]
fn linear_interpolation_between_keys() {
    for (time, expected) in [
        ("0", "10"),
        ("1", "10"),
        ("1.5", "12.5"),
        ("2", "15"),
        ("3", "20"),
        ("4", "10"),
        ("5", "0"),
        ("7", "-20"),
        ("8", "-20"),
        ("9", "-20"),
        ("-1", "10"),
    ] {
        let got = value(&RAMP, Linear, false, time);
        assert_eq!(got, expected.parse::<Real>().unwrap(), "at {time}");
    }
}

#[test]
fn interpolation_passes_through_keys() {
    for interpolation in [Linear, Smooth] {
        for key in RAMP {
            let got = value(&RAMP, interpolation, false, &key.time.to_string());
            assert_eq!(got, key.value.x);
        }
        let single = [Keyframe::number(real!(4), real!(5))];
        for time in ["0", "4", "8"] {
            assert_eq!(value(&single, interpolation, true, time), 5);
        }
    }
}

#[test]
fn loop_repeats_after_its_duration() {
    for time in ["8", "9.5", "17.25", "-2"] {
        let within = time.parse::<Real>().unwrap().rem_euclid(real!(8));
        assert_eq!(
            value(&RAMP, Smooth, true, time),
            value(&RAMP, Smooth, true, &within.to_string()),
        );
    }
}

/// Keys of y = 4t - t²/2 at uneven times. Smooth interpolation takes its slopes from
/// the parabola through three neighboring keys, so it reproduces a parabola exactly.
#[test]
fn smooth_interpolation_reproduces_parabola() {
    let keys = [
        Keyframe::number(real!(0), real!(0)),
        Keyframe::number(real!(1), real!(3.5)),
        Keyframe::number(real!(5), real!(7.5)),
        Keyframe::number(real!(8), real!(0)),
    ];
    for (time, expected) in [
        ("0.5", "1.875"),
        ("2", "6"),
        ("4", "8"),
        ("4.5", "7.875"),
        ("7", "3.5"),
    ] {
        assert_near(value(&keys, Smooth, false, time), expected);
    }
}

#[test]
fn smooth_interpolation_of_two_keys_is_linear() {
    let keys = [
        Keyframe::number(real!(0), real!(0)),
        Keyframe::number(real!(8), real!(16)),
    ];
    assert_eq!(value(&keys, Smooth, true, "3"), 6);
}

/// With evenly spaced keys, smooth interpolation is the Catmull-Rom spline (1974),
/// whose slope at a key is half the difference of its neighbors.
#[test]
fn smooth_interpolation_of_even_keys_is_catmull_rom() {
    let keys = [
        Keyframe::number(real!(0), real!(1)),
        Keyframe::number(real!(2), real!(3)),
        Keyframe::number(real!(4), real!(2)),
        Keyframe::number(real!(6), real!(5)),
    ];
    // (-p0 + 9 p1 + 9 p2 - p3) / 16
    assert_near(value(&keys, Smooth, false, "3"), "2.4375");
    // At a quarter of the segment: (-9 p0 + 111 p1 + 29 p2 - 3 p3) / 128.
    assert_near(value(&keys, Smooth, false, "2.5"), "2.8671875");
}

/// Returns the slope of the smooth interpolation just after a time.
fn speed(keys: &[Keyframe], looping: bool, time: &str) -> Real {
    let step = real!(0.0001);
    let time: Real = time.parse().unwrap();
    let at = |time: Real| value(keys, Smooth, looping, &time.to_string());
    (at(time + step) - at(time)) * 10_000
}

#[test]
fn doubled_key_makes_corner_or_jump() {
    let bounce = [
        Keyframe::number(real!(0), real!(0)),
        Keyframe::number(real!(2), real!(4)),
        Keyframe::number(real!(4), real!(0)),
        Keyframe::number(real!(4), real!(0)),
        Keyframe::number(real!(6), real!(4)),
        Keyframe::number(real!(8), real!(0)),
    ];
    // The slope changes from -4 to 4 at the doubled key.
    assert!((speed(&bounce, false, "3.9998") + Real::from(4)).abs() < real!(0.01));
    assert!((speed(&bounce, false, "4") - Real::from(4)).abs() < real!(0.01));
    let jump = [
        Keyframe::number(real!(0), real!(0)),
        Keyframe::number(real!(4), real!(1)),
        Keyframe::number(real!(4), real!(5)),
        Keyframe::number(real!(8), real!(6)),
    ];
    for interpolation in [Linear, Smooth] {
        assert_near(value(&jump, interpolation, false, "3"), "0.75");
        assert_eq!(value(&jump, interpolation, false, "4"), 5);
    }
}

#[test]
fn loop_with_equal_ends_is_smooth() {
    let wave = [
        Keyframe::number(real!(0), real!(0)),
        Keyframe::number(real!(1), real!(4)),
        Keyframe::number(real!(6), real!(-4)),
        Keyframe::number(real!(8), real!(0)),
    ];
    let (end, start) = (speed(&wave, true, "7.9998"), speed(&wave, true, "0"));
    assert!((end - start).abs() < real!(0.01), "{end} {start}");
    let doubled = [&wave[..1], &wave].concat();
    let (end, start) = (speed(&doubled, true, "7.9998"), speed(&doubled, true, "0"));
    assert!((end - start).abs() > real!(0.5), "{end} {start}");
}

#[test]
fn extreme_values_do_not_overflow() {
    let far = |time, x| Keyframe {
        time: Real::lit(time),
        value: Vec3::new(x, x, x),
    };
    let keys = [
        far("0", Real::MIN),
        far("0.0000000003", Real::MAX),
        far("7.9999999", Real::MIN),
        far("8", Real::MAX),
    ];
    for time in ["0.0000000002", "1", "4", "7.99999995"] {
        for interpolation in [Linear, Smooth] {
            for looping in [false, true] {
                value(&keys, interpolation, looping, time);
            }
        }
    }
}

#[test]
fn animates_every_target() {
    let track = |target, keys| Track {
        target,
        interpolation: Linear,
        keys,
    };
    let position: &[Keyframe] = &[
        Keyframe::vector(real!(0), vec3!(0, 0, 0)),
        Keyframe::vector(real!(2), vec3!(2, 4, 6)),
    ];
    let number: &[Keyframe] = &[
        Keyframe::number(real!(0), real!(1)),
        Keyframe::number(real!(2), real!(3)),
    ];
    let turn: &[Keyframe] = &[
        Keyframe::angles(real!(0), real!(0), real!(0)),
        Keyframe::angles(real!(2), real!(180), real!(0)),
    ];
    let tracks = [
        track(Target::CameraOrbit, turn),
        track(Target::CameraLookAt, position),
        track(Target::CameraFovy, number),
        track(Target::ObjectPosition(0), position),
        track(Target::ObjectRadius(1), number),
        track(Target::LightPosition(0), position),
        track(Target::LightColor(0), position),
    ];
    let animation = Animation {
        duration: real!(2),
        looping: false,
        tracks: &tracks,
    };
    let mut animated = AnimatedScene::<2, 1>::new();
    // Each frame must start from the authored scene, not from the previous frame.
    for _ in 0..2 {
        let frame = animated.frame(&SCENE, &animation, Real::ONE).unwrap();
        assert_eq!(frame.camera.look_at, vec3!(1, 2, 3));
        // The orbit turns the offset (-1, -1, 5) by 90 degrees to the right.
        assert_eq!(frame.camera.eye, vec3!(6, 1, 4));
        assert_eq!(frame.camera.fovy_deg, 2);
        let Shape::Plane { point, .. } = frame.objects[0].shape else {
            panic!("{frame:?}")
        };
        assert_eq!(point, vec3!(1, 2, 3));
        let expected = Object::sphere(vec3!(0, 1, 0), real!(2), MaterialId(0));
        assert_eq!(frame.objects[1], expected);
        let (at, color) = (vec3!(1, 2, 3), color!(1, 2, 3));
        assert_eq!(frame.lights, [Light::point(at, color)]);
    }
    let eye = [track(Target::CameraEye, position)];
    let animation = Animation {
        tracks: &eye,
        ..animation
    };
    let moved = animation.camera(CAMERA, Real::ONE).unwrap();
    assert_eq!(moved.eye, vec3!(1, 2, 3));
}

/// Returns the error of an animation with one looping track.
fn rejected(duration: &str, target: Target, keys: &[Keyframe]) -> AnimationError {
    let tracks = [Track {
        target,
        interpolation: Smooth,
        keys,
    }];
    let animation = Animation {
        duration: duration.parse().unwrap(),
        looping: true,
        tracks: &tracks,
    };
    AnimatedScene::<2, 1>::new()
        .frame(&SCENE, &animation, Real::ONE)
        .unwrap_err()
}

#[test]
fn rejects_invalid_animations() {
    let key = Keyframe::number(real!(1), real!(1));
    let late = Keyframe::number(real!(2), real!(1));
    let fovy = Target::CameraFovy;
    let track_error = |problem| AnimationError {
        track: Some(0),
        problem,
    };
    for duration in ["0", "-1", "16777217"] {
        let error = rejected(duration, fovy, &[key]);
        assert_eq!(error.problem, AnimationProblem::Duration);
        assert_eq!(error.track, None);
    }
    use AnimationProblem::*;
    for (target, keys, problem) in [
        (fovy, &[][..], NoKeys),
        (fovy, &[late, key], Unsorted(1)),
        (fovy, &[key, key, key], Crowded(2)),
        (
            fovy,
            &[key, Keyframe::number(real!(3.5), real!(1))],
            OutsideDuration(1),
        ),
        (
            fovy,
            &[Keyframe::number(real!(-1), real!(1))],
            OutsideDuration(0),
        ),
        (Target::ObjectPosition(2), &[key], NoSuchObject(2)),
        (Target::ObjectRadius(2), &[key], NoSuchObject(2)),
        (Target::ObjectRadius(0), &[key], NoRadius(0)),
        (Target::LightPosition(1), &[key], NoSuchLight(1)),
        (Target::LightColor(7), &[key], NoSuchLight(7)),
    ] {
        assert_eq!(rejected("3", target, keys), track_error(problem));
    }
    assert_eq!(
        rejected("3", fovy, &[late, key]).to_string(),
        "track 0: keyframe 1 is earlier than its predecessor"
    );
}

#[test]
fn rejects_scene_larger_than_animated_scene() {
    let animation = Animation {
        duration: Real::ONE,
        looping: false,
        tracks: &[],
    };
    let mut narrow = AnimatedScene::<1, 1>::new();
    let error = narrow.frame(&SCENE, &animation, Real::ZERO).unwrap_err();
    assert_eq!(error.problem, AnimationProblem::TooManyObjects);
    let mut dark = AnimatedScene::<2, 0>::new();
    let error = dark.frame(&SCENE, &animation, Real::ZERO).unwrap_err();
    assert_eq!(error.problem, AnimationProblem::TooManyLights);
}
