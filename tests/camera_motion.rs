//! `set_camera` and `orbited`: a prepared or decoded scene with a moved camera
//! draws the picture of a scene prepared with that camera.

use embedded_graphics::geometry::Size;
use whitted::scene::{SceneItem, SceneProblem};
use whitted::{Camera, PreparedScene, Real, Renderer, SceneBuffer, Vec3, real, vec3};
use whitted_sim::{picture::Picture, render, scene_file};

const SIZE: Size = Size::new(64, 48);

fn scene(name: &str) -> scene_file::SceneFile {
    scene_file::load(format!(
        "{}/tests/scenes/{name}.toml",
        env!("CARGO_MANIFEST_DIR")
    ))
    .unwrap()
}

fn draw(scene: &PreparedScene<'_>) -> Picture {
    render::linear(scene, SIZE)
}

fn distance(from: Vec3<Real>, to: Vec3<Real>) -> f64 {
    let [x, y, z] = [from.x - to.x, from.y - to.y, from.z - to.z].map(|c| c.to_num::<f64>());
    x.hypot(y).hypot(z)
}

/// Returns cameras close to the scene's own. The fixed-point scale of the prepared
/// scene fits all of them.
fn cameras(camera: Camera) -> impl Iterator<Item = Camera> {
    (1..=4).map(move |step| Camera {
        eye: Vec3 {
            x: camera.eye.x - Real::from(step) / 2,
            y: camera.eye.y + Real::from(step) / 4,
            ..camera.eye
        },
        look_at: Vec3 {
            y: camera.look_at.y + Real::from(step) / 8,
            ..camera.look_at
        },
        fovy_deg: camera.fovy_deg + Real::from(step),
        ..camera
    })
}

#[test]
fn set_camera_draws_same_picture_as_prepare() {
    let file = scene("whitted");
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut other = Box::new(scene_file::Buffer::new());
    let mut third = Box::new(scene_file::Buffer::new());
    let bytes = scene_file::compile(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/tests/scenes/whitted.toml"
    ))
    .unwrap();
    let mut moved = file.prepare(&mut buffer).unwrap();
    let mut decoded = third.decode(&bytes).unwrap();
    let first = draw(&moved);
    assert_eq!(decoded.camera(), file.scene().camera);
    for camera in cameras(decoded.camera()) {
        moved.set_camera(&camera).unwrap();
        decoded.set_camera(&camera).unwrap();
        let prepared = whitted::Scene {
            camera,
            ..file.scene()
        };
        let prepared = draw(&other.prepare(&prepared).unwrap());
        assert!(prepared != first);
        assert!(draw(&moved) == prepared);
        assert!(draw(&decoded) == prepared);
    }
    moved.set_camera(&file.scene().camera).unwrap();
    assert!(draw(&moved) == first);
}

#[test]
fn encode_after_set_camera() {
    let file = scene("whitted");
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut other = Box::new(scene_file::Buffer::new());
    let mut moved = file.prepare(&mut buffer).unwrap();
    // Opposite to the camera with which the scene was prepared.
    let behind = file.scene().camera.orbited(Real::from(180), Real::from(30));
    moved.set_camera(&behind).unwrap();
    let mut bytes = vec![0; moved.encoded_len()];
    moved.encode(&mut bytes).unwrap();
    let decoded = other.decode(&bytes).unwrap();
    assert!(draw(&decoded) == draw(&moved));
    assert_eq!(decoded.camera(), behind);
}

/// `prepare` may choose another fixed-point scale than the one that `set_camera`
/// keeps. At most 3 pixels may then differ by more than 1/255.
#[test]
fn orbit_matches_prepare_up_to_rounding() {
    for name in ["whitted", "every_surface", "sphereflake_3", "four_spheres"] {
        let file = scene(name);
        let mut buffer = Box::new(scene_file::Buffer::new());
        let mut other = Box::new(scene_file::Buffer::new());
        let mut moved = file.prepare(&mut buffer).unwrap();
        for yaw in (0..360).step_by(30) {
            let camera = file.scene().camera.orbited(yaw.into(), Real::ZERO);
            moved.set_camera(&camera).unwrap();
            let prepared = whitted::Scene {
                camera,
                ..file.scene()
            };
            let (moved, prepared) = (draw(&moved), draw(&other.prepare(&prepared).unwrap()));
            let differ = |(a, b): &(&whitted::Color<u16>, &whitted::Color<u16>)| {
                a.r.abs_diff(b.r)
                    .max(a.g.abs_diff(b.g))
                    .max(a.b.abs_diff(b.b))
                    > 257
            };
            let pixels = moved.pixels.iter().zip(&prepared.pixels);
            let differing = pixels.filter(differ).count();
            assert!(differing <= 3, "{name} at {yaw}: {differing} pixels");
        }
    }
}

/// Moves the eye away from `look_at`, by a multiple of their distance.
fn outward(camera: Camera, by: Real) -> Vec3<Real> {
    let offset = camera.eye - camera.look_at;
    camera.eye + Vec3::new(offset.x * by, offset.y * by, offset.z * by)
}

/// Scanline culling must not drop visible objects, even from the greatest distance
/// that the prepared scene allows.
#[test]
fn lines_match_pixels_at_any_distance() {
    let file = scene("every_surface");
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut moved = file.prepare(&mut buffer).unwrap();
    let camera = file.scene().camera;
    let mut scale = Real::ONE;
    while moved
        .set_camera(&Camera {
            eye: outward(camera, scale),
            ..camera
        })
        .is_ok()
    {
        let mut renderer = Renderer::new(&moved, SIZE);
        for y in 0..SIZE.height {
            let line: Vec<_> = renderer.line(y).collect();
            let pixels: Vec<_> = (0..SIZE.width).map(|x| renderer.pixel(x, y)).collect();
            assert_eq!(line, pixels);
        }
        scale += real!(0.25);
    }
    assert!(scale > 2, "{scale}");
}

#[test]
fn rejected_camera_leaves_scene_unchanged() {
    let file = scene("whitted");
    let mut buffer = Box::new(scene_file::Buffer::new());
    let mut moved = file.prepare(&mut buffer).unwrap();
    let before = draw(&moved);
    let camera = file.scene().camera;
    let bad = [
        (
            Camera {
                eye: vec3!(0, 0, 1000),
                ..camera
            },
            "eye",
            SceneProblem::OutOfReach,
        ),
        (
            Camera {
                look_at: camera.eye,
                ..camera
            },
            "look_at",
            SceneProblem::NoView,
        ),
        (
            Camera {
                up: camera.eye - camera.look_at,
                ..camera
            },
            "up",
            SceneProblem::AlongView,
        ),
    ];
    for (camera, field, problem) in bad {
        let error = moved.set_camera(&camera).unwrap_err();
        assert_eq!(
            (error.item, error.field, error.problem),
            (SceneItem::Camera, field, problem)
        );
        assert!(draw(&moved) == before);
        assert_eq!(moved.camera(), file.scene().camera);
    }
    let narrow = Camera {
        fovy_deg: Real::ZERO,
        ..camera
    };
    let error = moved.set_camera(&narrow).unwrap_err();
    assert_eq!(error.to_string(), "camera: fovy_deg must be from 1 to 170");
}

#[test]
fn orbit_keeps_distance() {
    let start = Camera::new(vec3!(0.2, 2.3, 8.2), vec3!(0.12, 1.22, 0), real!(33));
    let radius = distance(start.eye, start.look_at);
    let mut camera = start;
    for step in 0..720 {
        camera = camera.orbited(Real::ONE, Real::from(step % 3 - 1));
        let error = (distance(camera.eye, camera.look_at) / radius - 1.0).abs();
        assert!(
            error < f64::from(step + 1) * 2_f64.powi(-28),
            "{step}: {error}"
        );
    }
    assert_eq!(start.orbited(Real::ZERO, Real::ZERO), start);
    assert_eq!(start.orbited(Real::from(720), Real::ZERO), start);
}

#[test]
fn orbit_stops_at_89_degrees_elevation() {
    let start = Camera {
        up: vec3!(0.1, 3, 0.2),
        ..Camera::new(vec3!(3, 1, 4), vec3!(0, 1, 0), real!(33))
    };
    let elevation = |camera: Camera| {
        let offset = camera.eye - camera.look_at;
        let [x, y, z] = [offset.x, offset.y, offset.z].map(|c| c.to_num::<f64>());
        let along = (0.1 * x + 3.0 * y + 0.2 * z) / (0.01_f64 + 9.0 + 0.04).sqrt();
        (along / distance(camera.eye, camera.look_at))
            .asin()
            .to_degrees()
    };
    let level = elevation(start);
    for pitch in -400..400_i32 {
        let expected = (level + f64::from(pitch)).clamp(-89.0, 89.0);
        let got = elevation(start.orbited(Real::from(25), Real::from(pitch)));
        assert!(
            (got - expected).abs() < 0.12,
            "{pitch}: {got}, expected {expected}"
        );
    }
    // At the limit the camera is still valid, and can turn back.
    let mut top = start.orbited(Real::ZERO, Real::from(100));
    for _ in 0..10 {
        top = top.orbited(Real::ZERO, Real::from(10));
        assert!((elevation(top) - 89.0).abs() < 0.001);
        assert!(
            SceneBuffer::<1, 1, 1>::new()
                .prepare(&whitted::Scene::new(top))
                .is_ok()
        );
    }
    let back = top.orbited(Real::ZERO, Real::from(-30));
    assert!((elevation(back) - 59.0).abs() < 0.12);
}

#[test]
fn orbit_of_degenerate_camera_changes_nothing() {
    let above = Camera::new(vec3!(0, 5, 0), vec3!(0, 1, 0), real!(33));
    let (yaw, pitch) = (Real::from(40), Real::from(20));
    assert_eq!(above.orbited(yaw, pitch), above);
    let degenerate = Camera {
        look_at: above.eye,
        ..above
    };
    assert_eq!(degenerate.orbited(yaw, pitch), degenerate);
    // Coordinates at the ends of their range must not overflow.
    let extreme = Camera {
        eye: Vec3::new(Real::MAX, Real::MIN, Real::MAX),
        look_at: Vec3::new(Real::MIN, Real::MAX, Real::MIN),
        ..above
    };
    let _ = extreme.orbited(Real::MAX, Real::MIN);
}
