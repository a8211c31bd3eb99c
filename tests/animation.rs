//! Key frames: values between keys, loops, and what is refused.

#![allow(clippy::unwrap_used)]

use whitted::animation::{
    AnimatedScene, Animation, AnimationError, AnimationProblem, Interpolation, Keyframe, Target,
    Track,
};
use whitted::{Camera, Color, Light, MaterialId, Object, Real, Scene, Shape, Texture, Vec3};

use Interpolation::{Linear, Smooth};

const CAMERA: Camera = Camera::new(
    Vec3::lit("0", "1", "8"),
    Vec3::lit("0", "1", "0"),
    Real::lit("33"),
);
const BALL: Object = Object::sphere(Vec3::lit("0", "1", "0"), Real::ONE, MaterialId(0));
const FLOOR: Object = Object::floor(Real::ZERO, Texture::Uniform(MaterialId(0)));
const LAMP: Light = Light::point(Vec3::lit("-6", "11", "7"), Color::gray(Real::ONE));

const STILL: Scene<'static> = Scene {
    lights: &[LAMP],
    objects: &[FLOOR, BALL],
    ..Scene::new(CAMERA)
};

/// The field of view is any number here, and nothing checks it.
fn value(keys: &[Keyframe], interpolation: Interpolation, looping: bool, time: &str) -> Real {
    let tracks = [Track {
        target: Target::CameraFovy,
        interpolation,
        keys,
    }];
    let animation = Animation {
        duration: Real::lit("8"),
        looping,
        tracks: &tracks,
    };
    let time = time.parse().unwrap();
    animation.camera(CAMERA, time).unwrap().fovy_deg
}

#[track_caller]
fn assert_near(a: Real, b: &str) {
    let b: Real = b.parse().unwrap();
    assert!((a - b).abs() < Real::lit("0.00000001"), "{a}, not {b}");
}

const RAMP: [Keyframe; 3] = [
    Keyframe::number("1", "10"),
    Keyframe::number("3", "20"),
    Keyframe::number("7", "-20"),
];

#[test]
fn lines_lead_from_key_to_key() {
    for (time, right) in [
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
        assert_eq!(got, right.parse::<Real>().unwrap(), "at {time}");
    }
}

#[test]
fn both_kinds_pass_through_the_keys() {
    for interpolation in [Linear, Smooth] {
        for key in RAMP {
            let got = value(&RAMP, interpolation, false, &key.time.to_string());
            assert_eq!(got, key.value.x);
        }
        let alone = [Keyframe::number("4", "5")];
        for time in ["0", "4", "8"] {
            assert_eq!(value(&alone, interpolation, true, time), 5);
        }
    }
}

#[test]
fn a_loop_begins_anew() {
    for time in ["8", "9.5", "17.25", "-2"] {
        let within = time.parse::<Real>().unwrap().rem_euclid(Real::lit("8"));
        assert_eq!(
            value(&RAMP, Smooth, true, time),
            value(&RAMP, Smooth, true, &within.to_string()),
        );
    }
}

/// y = 4 t - t²/2, at uneven times: two parabolas at the ends, and between them
/// slopes of parabolas.
#[test]
fn a_throw_is_a_parabola() {
    let keys = [
        Keyframe::number("0", "0"),
        Keyframe::number("1", "3.5"),
        Keyframe::number("5", "7.5"),
        Keyframe::number("8", "0"),
    ];
    for (time, right) in [
        ("0.5", "1.875"),
        ("2", "6"),
        ("4", "8"),
        ("4.5", "7.875"),
        ("7", "3.5"),
    ] {
        assert_near(value(&keys, Smooth, false, time), right);
    }
}

#[test]
fn two_keys_are_joined_by_a_line() {
    let keys = [Keyframe::number("0", "0"), Keyframe::number("8", "16")];
    assert_eq!(value(&keys, Smooth, true, "3"), 6);
}

/// Catmull and Rom's spline, where times are even: slopes of half the way between
/// the neighbors.
#[test]
fn even_times_give_the_usual_spline() {
    let keys = [
        Keyframe::number("0", "1"),
        Keyframe::number("2", "3"),
        Keyframe::number("4", "2"),
        Keyframe::number("6", "5"),
    ];
    // (-p0 + 9 p1 + 9 p2 - p3) / 16
    assert_near(value(&keys, Smooth, false, "3"), "2.4375");
    // By the four weights at a quarter: (-9 p0 + 111 p1 + 29 p2 - 3 p3) / 128.
    assert_near(value(&keys, Smooth, false, "2.5"), "2.8671875");
}

fn speed(keys: &[Keyframe], looping: bool, time: &str) -> Real {
    let step = Real::lit("0.0001");
    let time: Real = time.parse().unwrap();
    let at = |time: Real| value(keys, Smooth, looping, &time.to_string());
    (at(time + step) - at(time)) * 10_000
}

#[test]
fn a_doubled_key_is_a_corner() {
    let bounce = [
        Keyframe::number("0", "0"),
        Keyframe::number("2", "4"),
        Keyframe::number("4", "0"),
        Keyframe::number("4", "0"),
        Keyframe::number("6", "4"),
        Keyframe::number("8", "0"),
    ];
    // Down by a slope of 4, and up again.
    assert!((speed(&bounce, false, "3.9998") + Real::from(4)).abs() < Real::lit("0.01"));
    assert!((speed(&bounce, false, "4") - Real::from(4)).abs() < Real::lit("0.01"));
    let jump = [
        Keyframe::number("0", "0"),
        Keyframe::number("4", "1"),
        Keyframe::number("4", "5"),
        Keyframe::number("8", "6"),
    ];
    for interpolation in [Linear, Smooth] {
        assert_near(value(&jump, interpolation, false, "3"), "0.75");
        assert_eq!(value(&jump, interpolation, false, "4"), 5);
    }
}

#[test]
fn a_loop_closes_smoothly_where_its_ends_are_alike() {
    let wave = [
        Keyframe::number("0", "0"),
        Keyframe::number("1", "4"),
        Keyframe::number("6", "-4"),
        Keyframe::number("8", "0"),
    ];
    let (end, start) = (speed(&wave, true, "7.9998"), speed(&wave, true, "0"));
    assert!((end - start).abs() < Real::lit("0.01"), "{end} {start}");
    let doubled = [&wave[..1], &wave].concat();
    let (end, start) = (speed(&doubled, true, "7.9998"), speed(&doubled, true, "0"));
    assert!((end - start).abs() > Real::lit("0.5"), "{end} {start}");
}

/// Nothing overflows.
#[test]
fn the_farthest_values_are_no_harm() {
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
fn all_targets_move() {
    let half = |target, keys| Track {
        target,
        interpolation: Linear,
        keys,
    };
    let position: &[Keyframe] = &[
        Keyframe::vector("0", "0", "0", "0"),
        Keyframe::vector("2", "2", "4", "6"),
    ];
    let number: &[Keyframe] = &[Keyframe::number("0", "1"), Keyframe::number("2", "3")];
    let turn: &[Keyframe] = &[
        Keyframe::angles("0", "0", "0"),
        Keyframe::angles("2", "180", "0"),
    ];
    let tracks = [
        half(Target::CameraOrbit, turn),
        half(Target::CameraLookAt, position),
        half(Target::CameraFovy, number),
        half(Target::ObjectPosition(0), position),
        half(Target::ObjectRadius(1), number),
        half(Target::LightPosition(0), position),
        half(Target::LightColor(0), position),
    ];
    let animation = Animation {
        duration: Real::lit("2"),
        looping: false,
        tracks: &tracks,
    };
    let mut stage = AnimatedScene::<2, 1>::new();
    // The second frame starts from the still scene, too.
    for _ in 0..2 {
        let frame = stage.frame(&STILL, &animation, Real::ONE).unwrap();
        assert_eq!(frame.camera.look_at, Vec3::lit("1", "2", "3"));
        // (-1, -1, 5) to the right by 90 degrees.
        assert_eq!(frame.camera.eye, Vec3::lit("6", "1", "4"));
        assert_eq!(frame.camera.fovy_deg, 2);
        let Shape::Plane { point, .. } = frame.objects[0].shape else {
            panic!("{frame:?}")
        };
        assert_eq!(point, Vec3::lit("1", "2", "3"));
        let right = Object::sphere(Vec3::lit("0", "1", "0"), Real::lit("2"), MaterialId(0));
        assert_eq!(frame.objects[1], right);
        let (at, color) = (Vec3::lit("1", "2", "3"), Color::lit("1", "2", "3"));
        assert_eq!(frame.lights, [Light::point(at, color)]);
    }
    let eye = [half(Target::CameraEye, position)];
    let animation = Animation {
        tracks: &eye,
        ..animation
    };
    let moved = animation.camera(CAMERA, Real::ONE).unwrap();
    assert_eq!(moved.eye, Vec3::lit("1", "2", "3"));
}

fn refused(duration: &str, target: Target, keys: &[Keyframe]) -> AnimationError {
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
        .frame(&STILL, &animation, Real::ONE)
        .unwrap_err()
}

#[test]
fn what_cannot_be_is_refused() {
    let key = Keyframe::number("1", "1");
    let late = Keyframe::number("2", "1");
    let fovy = Target::CameraFovy;
    let of = |problem| AnimationError {
        track: Some(0),
        problem,
    };
    for duration in ["0", "-1", "16777217"] {
        let error = refused(duration, fovy, &[key]);
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
            &[key, Keyframe::number("3.5", "1")],
            OutsideDuration(1),
        ),
        (fovy, &[Keyframe::number("-1", "1")], OutsideDuration(0)),
        (Target::ObjectPosition(2), &[key], NoSuchObject(2)),
        (Target::ObjectRadius(2), &[key], NoSuchObject(2)),
        (Target::ObjectRadius(0), &[key], NoRadius(0)),
        (Target::LightPosition(1), &[key], NoSuchLight(1)),
        (Target::LightColor(7), &[key], NoSuchLight(7)),
    ] {
        assert_eq!(refused("3", target, keys), of(problem));
    }
    assert_eq!(
        refused("3", fovy, &[late, key]).to_string(),
        "track 0: keyframe 1 is earlier than its predecessor"
    );
}

#[test]
fn a_stage_must_be_large_enough() {
    let animation = Animation {
        duration: Real::ONE,
        looping: false,
        tracks: &[],
    };
    let mut narrow = AnimatedScene::<1, 1>::new();
    let error = narrow.frame(&STILL, &animation, Real::ZERO).unwrap_err();
    assert_eq!(error.problem, AnimationProblem::TooManyObjects);
    let mut dark = AnimatedScene::<2, 0>::new();
    let error = dark.frame(&STILL, &animation, Real::ZERO).unwrap_err();
    assert_eq!(error.problem, AnimationProblem::TooManyLights);
}
