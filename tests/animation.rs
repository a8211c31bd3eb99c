//! Keyframe animation: interpolation, loops, targets, scale, compiled animations and rejected
//! animations.

use embedded_graphics::prelude::*;
use whitted::animation::{
    Animation, AnimationError, AnimationProblem, Interpolation, Keyframe, Target, Track,
};
use whitted::scene::{SceneItem, SceneProblem};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, PreparedScene, Real, Scene,
    SceneBuffer, SceneError, Shape, Texture, Vec3, color, real, vec3,
};
use whitted_sim::{render, scene_file};

use Interpolation::{Linear, Smooth};

type Buffer = SceneBuffer<9, 1, 1>;

const CAMERA: Camera = Camera::new(vec3!(0, 1, 8), vec3!(0, 1, 0), real!(33));
const BALL: Object = Object::sphere(vec3!(0, 1, 0), Real::ONE, MaterialId(0));
const FLOOR: Object = Object::floor(Real::ZERO, Texture::Uniform(MaterialId(0)));
/// A sphere around the scene. Scenes with this sphere have the same scale.
const SKY: Object = Object::sphere(vec3!(0, 0, 0), real!(50), MaterialId(0));
const LAMP: Light = Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE));

const SCENE: Scene<'static> = Scene {
    lights: &[LAMP],
    materials: &[Material::BLACK],
    objects: &[FLOOR, BALL, SKY],
    // Scenes with this background have the same exposure.
    background: Background::Solid(Color::gray(real!(8))),
    ..Scene::new(CAMERA)
};

/// Interpolates a track at a time, in an animation of 8 seconds. The target is the x coordinate of
/// a camera that looks along the z axis.
fn value(keys: &[Keyframe], interpolation: Interpolation, looping: bool, time: &str) -> Real {
    let tracks = [Track {
        target: Target::CameraEye,
        interpolation,
        keys,
    }];
    let animation = Animation {
        duration: real!(8),
        looping,
        tracks: &tracks,
    };
    let look_at = vec3!(0, 0, -1000);
    let scene = Scene::new(Camera { look_at, ..CAMERA });
    let mut buffer = Buffer::new();
    let mut animation = buffer.prepare_animation(&scene, &animation).unwrap();
    let frame = animation.frame(time.parse().unwrap()).unwrap();
    frame.camera().eye.x
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

/// Angles may have any value.
#[test]
fn extreme_values_do_not_overflow() {
    let far = |time, x| Keyframe {
        time,
        value: Vec3::new(x, x, x),
    };
    let keys = [
        far(real!(0), Real::MIN),
        far(real!(0.0000000003), Real::MAX),
        far(real!(7.9999999), Real::MIN),
        far(real!(8), Real::MAX),
    ];
    for interpolation in [Linear, Smooth] {
        for looping in [false, true] {
            let animation = Animation {
                duration: real!(8),
                looping,
                tracks: &[Track {
                    target: Target::CameraOrbit,
                    interpolation,
                    keys: &keys,
                }],
            };
            let mut buffer = Buffer::new();
            let mut animation = buffer.prepare_animation(&SCENE, &animation).unwrap();
            for time in ["0.0000000002", "1", "4", "7.99999995"] {
                animation.frame(time.parse().unwrap()).unwrap();
            }
        }
    }
}

fn track(target: Target, keys: &[Keyframe]) -> Track<'_> {
    Track {
        target,
        interpolation: Linear,
        keys,
    }
}

fn encoded(scene: &PreparedScene<'_>) -> Vec<u8> {
    let mut bytes = vec![0; scene.encoded_len()];
    assert_eq!(scene.encode(&mut bytes), Some(bytes.len()));
    bytes
}

#[test]
fn animates_every_target() {
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
    let at = vec3!(1, 2, 3);
    let mut floor = FLOOR;
    let Shape::Plane { point, .. } = &mut floor.shape else {
        panic!("{floor:?}")
    };
    *point = at;
    let ball = Object::sphere(vec3!(0, 1, 0), real!(2), MaterialId(0));
    let camera = Camera {
        // The orbit turns the offset (-1, -1, 5) by 90 degrees to the right.
        eye: vec3!(6, 1, 4),
        look_at: at,
        fovy_deg: real!(2),
        ..CAMERA
    };
    let expected = Scene {
        camera,
        lights: &[Light::point(at, color!(1, 2, 3))],
        objects: &[floor, ball, SKY],
        ..SCENE
    };
    let expected = encoded(&Buffer::new().prepare(&expected).unwrap());
    let mut buffer = Buffer::new();
    let mut animation = buffer.prepare_animation(&SCENE, &animation).unwrap();
    // Each frame must start from the authored scene, not from the previous frame.
    for time in ["1", "2", "1"] {
        let frame = animation.frame(time.parse().unwrap()).unwrap();
        assert_eq!(encoded(&frame) == expected, time == "1");
    }
    let eye = [
        Keyframe::vector(real!(0), vec3!(0, 0, 4)),
        Keyframe::vector(real!(2), vec3!(2, 4, 2)),
    ];
    let keys = [track(Target::CameraEye, &eye)];
    let animation = Animation {
        duration: real!(2),
        looping: false,
        tracks: &keys,
    };
    let mut animation = buffer.prepare_animation(&SCENE, &animation).unwrap();
    assert_eq!(animation.frame(Real::ONE).unwrap().camera().eye, at);
}

/// Smooth tracks for objects of all shapes, which overshoot their keyframes.
fn moving_shapes(random: &mut fastrand::Rng) -> (Vec<Object>, Vec<(Target, Vec<Keyframe>)>) {
    let center = || vec3!(0, 1, 0);
    let radius = real!(0.75);
    let y = [Real::ZERO, Real::ONE];
    let flake = Object::sphereflake(center(), radius, 3, MaterialId(0)).shape;
    let shapes = [
        BALL.shape,
        FLOOR.shape,
        flake,
        Shape::Ellipsoid {
            center: center(),
            radii: vec3!(1, 2, 0.5),
        },
        Shape::Cylinder {
            origin: center(),
            radius,
            y: Some(y),
        },
        Shape::Cylinder {
            origin: center(),
            radius,
            y: None,
        },
        Shape::Cone {
            origin: center(),
            radius,
            height: Real::ONE,
            y: Some(y),
        },
        Shape::Paraboloid {
            origin: center(),
            y,
        },
    ];
    let objects = shapes.map(|shape| Object {
        shape,
        texture: Texture::Uniform(MaterialId(0)),
    });
    let mut number = |low: f64, high: f64| Real::from_num(low + (high - low) * random.f64());
    let mut keys = |low, high| -> Vec<Keyframe> {
        let mut times = [(); 5].map(|()| number(0.0, 4.0));
        times.sort();
        let times = times.into_iter();
        let key = |time| Keyframe {
            time,
            value: Vec3::new(number(low, high), number(low, high), number(low, high)),
        };
        times.map(key).collect()
    };
    let mut tracks = vec![(Target::LightPosition(0), keys(-30.0, 30.0))];
    for index in 0..8 {
        tracks.push((Target::ObjectPosition(index), keys(-9.0, 9.0)));
        if [0, 2, 4, 5, 6].contains(&index) {
            tracks.push((Target::ObjectRadius(index), keys(1.0, 1.5)));
        }
    }
    tracks.push((Target::LightColor(0), keys(3.0, 7.0)));
    tracks.push((Target::CameraFovy, keys(60.0, 90.0)));
    (objects.to_vec(), tracks)
}

/// All frames of a valid animation are valid scenes, and those of the compiled animation are equal.
#[test]
fn every_frame_is_valid_and_equals_the_compiled_frame() {
    let random = &mut fastrand::Rng::with_seed(1);
    let mut played = 0;
    for _ in 0..40 {
        let (objects, tracks) = moving_shapes(random);
        let tracks: Vec<_> = tracks
            .iter()
            .map(|(target, keys)| Track {
                interpolation: Smooth,
                ..track(*target, keys)
            })
            .collect();
        let animation = Animation {
            duration: real!(4),
            looping: true,
            tracks: &tracks,
        };
        let scene = Scene {
            objects: &objects,
            ..SCENE
        };
        let mut buffer = Box::new(Buffer::new());
        // Some curves overshoot the range of their target.
        let Ok(mut animation) = buffer.prepare_animation(&scene, &animation) else {
            continue;
        };
        played += 1;
        let mut bytes = vec![0; animation.encoded_len()];
        assert_eq!(animation.encode(&mut bytes), Some(bytes.len()));
        let mut other = Box::new(Buffer::new());
        let mut compiled = other.decode_animation(&bytes).unwrap();
        for _ in 0..20 {
            let time = Real::from_num(4.0 * random.f64());
            let frame = encoded(&animation.frame(time).unwrap());
            Buffer::new().decode(&frame).unwrap();
            assert!(encoded(&compiled.frame(time).unwrap()) == frame);
        }
    }
    assert!(played > 10, "only {played} animations are valid");
}

/// A smooth track that stays within the range of its target must not leave it by rounding.
#[test]
fn rounding_does_not_leave_the_range() {
    let keys = |values: [i32; 4]| {
        let times = [real!(0), real!(1.3), real!(3.1), real!(4)];
        [0, 1, 2, 3].map(|i| Keyframe::number(times[i], Real::from(values[i])))
    };
    let fovy = keys([170, 1, 1, 170]);
    let color = keys([0, 256, 256, 0]);
    let tracks = [(Target::CameraFovy, &fovy), (Target::LightColor(0), &color)];
    let tracks = tracks.map(|(target, keys)| Track {
        // Doubled keyframes at the ends of each segment make it straight.
        interpolation: Smooth,
        ..track(target, keys)
    });
    let linear = tracks.map(|track| Track {
        interpolation: Linear,
        ..track
    });
    for tracks in [linear.as_slice(), &tracks] {
        let animation = Animation {
            duration: real!(4),
            looping: true,
            tracks,
        };
        let mut buffer = Buffer::new();
        let Ok(mut animation) = buffer.prepare_animation(&SCENE, &animation) else {
            continue;
        };
        for step in 0..1000 {
            let time = Real::from(step) / 250;
            Buffer::new()
                .decode(&encoded(&animation.frame(time).unwrap()))
                .unwrap();
        }
    }
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
    let mut buffer = Buffer::new();
    buffer.prepare_animation(&SCENE, &animation).unwrap_err()
}

#[test]
fn rejects_values_out_of_range() {
    let number = Keyframe::number;
    // The slope at the second keyframe carries the radius below 0.
    let overshoot = [
        number(real!(0), real!(1)),
        number(real!(1), real!(0.01)),
        number(real!(3), real!(2)),
    ];
    let far = Keyframe::vector(real!(1), vec3!(0, 0, 16777217));
    let eye = Keyframe::vector(real!(1), vec3!(0, 1, 0));
    for (target, keys, key, item, field) in [
        (
            Target::ObjectRadius(1),
            &overshoot[..],
            1,
            SceneItem::Object(1),
            "radius",
        ),
        (
            Target::CameraFovy,
            &[number(real!(0), real!(33)), number(real!(1), real!(171))],
            1,
            SceneItem::Camera,
            "fovy_deg",
        ),
        (Target::CameraEye, &[far], 0, SceneItem::Camera, "eye"),
        (Target::CameraEye, &[eye], 0, SceneItem::Camera, "look_at"),
        (
            Target::ObjectPosition(0),
            &[far],
            0,
            SceneItem::Object(0),
            "point",
        ),
        (
            Target::ObjectPosition(1),
            &[far],
            0,
            SceneItem::Object(1),
            "center",
        ),
        (
            Target::LightPosition(0),
            &[far],
            0,
            SceneItem::Light(0),
            "position",
        ),
        (
            Target::LightColor(0),
            &[number(real!(0), real!(-0.1))],
            0,
            SceneItem::Light(0),
            "diffuse",
        ),
    ] {
        let AnimationError { track, problem } = rejected("3", target, keys);
        let AnimationProblem::Value(found, error) = problem else {
            panic!("{target:?}: {problem}")
        };
        assert_eq!((track, found), (Some(0), key), "{target:?}");
        assert_eq!((error.item, error.field), (item, field));
    }
    // The radius is too small for the scale, to which the animation of the light adds.
    let small = [
        number(real!(0), real!(0.0001)),
        number(real!(1), real!(0.0001)),
    ];
    let AnimationProblem::Value(0, error) = rejected("3", Target::ObjectRadius(1), &small).problem
    else {
        panic!("accepted")
    };
    assert!(matches!(error.problem, SceneProblem::OutOfRange { .. }));
    let message =
        rejected("3", Target::LightColor(0), &[number(real!(0), real!(-0.1))]).to_string();
    assert_eq!(
        message,
        "track 0: keyframe 0: light 0: diffuse must be from 0 to 256"
    );
}

#[test]
fn rejects_invalid_scenes() {
    let animation = Animation {
        duration: Real::ONE,
        looping: false,
        tracks: &[],
    };
    let camera = Camera {
        fovy_deg: Real::ZERO,
        ..CAMERA
    };
    let mut buffer = Buffer::new();
    let error = buffer.prepare_animation(&Scene::new(camera), &animation);
    let AnimationProblem::Scene(SceneError { field, .. }) = error.unwrap_err().problem else {
        panic!("accepted")
    };
    assert_eq!(field, "fovy_deg");
    let mut small = SceneBuffer::<1, 1, 1>::new();
    let error = small.prepare_animation(&SCENE, &animation).unwrap_err();
    assert_eq!(
        error.to_string(),
        "animation: scene: objects exceed the buffer's capacity of 1"
    );
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
        (Target::ObjectPosition(3), &[key], NoSuchObject(3)),
        (Target::ObjectRadius(3), &[key], NoSuchObject(3)),
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

/// A later frame sets flags of objects, for example that no object hides them from a light. An
/// earlier frame that is drawn again must not keep these flags.
#[test]
fn frames_do_not_depend_on_the_frames_before() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/scenes/bouncing_ball.toml"
    );
    let bytes = scene_file::compile(path).unwrap();
    let [mut buffer, mut other] = [(); 2].map(|()| Box::new(scene_file::Buffer::new()));
    let mut animation = buffer.decode_animation(&bytes).unwrap();
    let size = Size::new(128, 64);
    for time in [real!(1.125), real!(0), real!(3.5), real!(0.25)] {
        let drawn = render::linear(&animation.frame(time).unwrap(), size);
        let mut alone = other.decode_animation(&bytes).unwrap();
        let expected = render::linear(&alone.frame(time).unwrap(), size);
        assert!(drawn.pixels == expected.pixels, "at {time} s");
    }
}
