//! Contract of the antialiased renderer: a line does not depend on the order of
//! rendering, and only edge pixels get extra rays.

use crate::common::line_display::LineDisplay;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use whitted::observer::Stats;
use whitted::render::{AaSample, AntialiasError, AntialiasedRenderer, SampleCount};
use whitted::scene::Axis;
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Radiance, Real, Renderer,
    Scene, SceneBuffer, Texture, color, real, vec3,
};

const DULL: Material = Material {
    kd: color!(0.7, 0.7, 0.7),
    ..Material::BLACK
};

const SCENE: Scene = Scene {
    lights: &[Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE))],
    materials: &[DULL, DULL],
    objects: &[
        Object::sphere(vec3!(0, 1, 0), Real::ONE, MaterialId(0)),
        Object::floor(Real::ZERO, Texture::Uniform(MaterialId(1))),
    ],
    ..Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)))
};

const SIZE: Size = Size::new(40, 30);
type Memory = [AaSample; 2 * SIZE.width as usize];
const MEMORY: Memory = [AaSample::BLACK; 2 * SIZE.width as usize];
type Buffer = SceneBuffer<2, 1, 2>;

fn all_lines(scene: &Scene<'_>, samples: SampleCount) -> (Vec<Vec<Color<Radiance>>>, Stats) {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(scene).unwrap();
    let mut memory = MEMORY;
    let mut renderer =
        AntialiasedRenderer::with_observer(&scene, SIZE, samples, &mut memory, Stats::default())
            .unwrap();
    let lines = (0..SIZE.height)
        .map(|y| renderer.line(y).collect())
        .collect();
    (lines, *renderer.observer())
}

#[test]
fn lines_do_not_depend_on_order() {
    for samples in [SampleCount::Four, SampleCount::Sixteen] {
        let (lines, _) = all_lines(&SCENE, samples);
        let mut buffer = Buffer::new();
        let scene = buffer.prepare(&SCENE).unwrap();
        let mut memory = MEMORY;
        let mut renderer = AntialiasedRenderer::new(&scene, SIZE, samples, &mut memory).unwrap();
        let backward = (0..SIZE.height).rev();
        let repeated = [0, 0, 1, 0, 2, 3, 3, 4, 29, 29, 0, 15, 17, 16];
        for y in backward.chain(repeated) {
            let line: Vec<_> = renderer.line(y).collect();
            assert_eq!(line, lines[y as usize], "line {y}");
        }
        assert_eq!(renderer.line(SIZE.height).count(), 0);
        assert_eq!(renderer.line(u32::MAX).count(), 0);
        assert_eq!(renderer.line(3).count(), SIZE.width as usize);
    }
}

#[test]
fn only_edge_pixels_differ_from_plain_picture() {
    let (lines, stats) = all_lines(&SCENE, SampleCount::Four);
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE).unwrap();
    let mut renderer = Renderer::new(&scene, SIZE);
    let mut changed = 0;
    for (y, line) in (0..).zip(&lines) {
        changed += renderer.line(y).zip(line).filter(|(a, b)| a != *b).count();
    }
    let pixels = SIZE.width * SIZE.height;
    let edges = (stats.camera - pixels) / 4;
    assert_eq!((stats.camera - pixels) % 4, 0);
    assert!((50..pixels / 3).contains(&edges), "{edges}");
    assert!(changed <= edges as usize && changed > edges as usize / 2);
}

#[test]
fn four_and_sixteen_rays_share_edge_pixels() {
    let [four, sixteen] = [SampleCount::Four, SampleCount::Sixteen].map(|samples| {
        let (_, stats) = all_lines(&SCENE, samples);
        stats.camera - SIZE.width * SIZE.height
    });
    assert_eq!(sixteen, 4 * four);
}

/// Returns the number of camera rays beyond one per pixel.
fn extra_rays(scene: &Scene<'_>) -> u32 {
    all_lines(scene, SampleCount::Four).1.camera - SIZE.width * SIZE.height
}

#[test]
fn edges_are_at_differences_of_object_material_shadow_or_color() {
    let dim = Background::Solid(color!(0.01, 0.01, 0.01));
    let floor = [Object::floor(Real::ZERO, Texture::Uniform(MaterialId(0)))];
    let plain = Scene {
        background: dim,
        objects: &[],
        ..SCENE
    };
    assert_eq!(extra_rays(&plain), 0);

    // Object edge, although both sides have the same color.
    let dark = Scene {
        lights: &[],
        objects: &floor,
        ..plain
    };
    let horizon = extra_rays(&dark);
    assert_eq!(horizon, 4 * 2 * SIZE.width);

    // Material edge, although both materials have the same color.
    let board = Texture::Checker {
        axes: [Axis::X, Axis::Z],
        size: real!(2),
        materials: [MaterialId(0), MaterialId(1)],
    };
    let tiled = Scene {
        objects: &[Object::floor(Real::ZERO, board)],
        ..dark
    };
    assert!(extra_rays(&tiled) > 2 * horizon);

    // Shadow edge, although the light is almost invisible.
    let faint = [Light::point(vec3!(-6, 11, 7), color!(0.001, 0.001, 0.001))];
    let ball = [SCENE.objects[0], floor[0]];
    let unlit = Scene {
        objects: &ball,
        ..dark
    };
    let lit = Scene {
        lights: &faint,
        ..unlit
    };
    assert!(extra_rays(&lit) > extra_rays(&unlit) + 40);

    // Color edge within one background, only where the gradient is steep.
    let sky = Scene {
        background: Background::Gradient {
            horizon: Color::gray(Real::ZERO),
            zenith: Color::gray(Real::ONE),
        },
        ..plain
    };
    assert_eq!(extra_rays(&sky), 0);
    let wide = Camera {
        fovy_deg: real!(120),
        ..SCENE.camera
    };
    let steep = Scene {
        camera: wide,
        ..sky
    };
    assert!(extra_rays(&steep) > 4 * SIZE.width);
}

#[test]
fn accepts_every_size() {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE).unwrap();
    for (width, height) in [(0, 0), (0, 5), (5, 0), (1, 1), (40, 1), (1, 40), (39, 41)] {
        let mut memory = MEMORY;
        let size = Size::new(width, height);
        let renderer = AntialiasedRenderer::new(&scene, size, SampleCount::Sixteen, &mut memory);
        let mut renderer = renderer.unwrap();
        for y in 0..height {
            assert_eq!(renderer.line(y).count(), width as usize);
        }
    }
}

#[test]
fn rejects_short_memory_and_large_pictures() {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE).unwrap();
    let mut memory = MEMORY;
    let mut error = |size, count: usize| {
        let memory = &mut memory[..count];
        AntialiasedRenderer::new(&scene, size, SampleCount::Four, memory).err()
    };
    let needs = |samples| Some(AntialiasError::TooLittleMemory { samples });
    assert_eq!(error(SIZE, 80), None);
    assert_eq!(error(SIZE, 79), needs(80));
    assert_eq!(error(SIZE, 0), needs(80));
    assert_eq!(
        error(Size::new(8192, 1), 80),
        Some(AntialiasError::TooLarge)
    );
    assert_eq!(error(Size::new(1, 8191), 80), None);
    assert_eq!(
        error(Size::new(1, u32::MAX), 80),
        Some(AntialiasError::TooLarge)
    );
    let message = AntialiasError::TooLittleMemory { samples: 80 }.to_string();
    assert_eq!(message, "the memory is too small: provide 80 samples");
}

#[test]
fn redrawing_a_failed_line_traces_no_rays() {
    let (_, once) = all_lines(&SCENE, SampleCount::Four);
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&SCENE).unwrap();
    let mut memory = MEMORY;
    let stats = Stats::default();
    let renderer =
        AntialiasedRenderer::with_observer(&scene, SIZE, SampleCount::Four, &mut memory, stats);
    let mut renderer = renderer.unwrap();
    let mut display = LineDisplay::default();
    for y in 0..SIZE.height {
        // Every line fails once, after 17 pixels.
        display.fails_at = Some((y as usize, 17));
        assert!(renderer.draw_line(y, &mut display).is_err());
        display.fails_at = None;
        renderer.draw_line(y, &mut display).unwrap();
    }
    assert_eq!(*renderer.observer(), once);
    for (y, (area, shown)) in (0..).zip(&display.lines) {
        assert_eq!(area.top_left, Point::new(0, y));
        let mut line = [Rgb888::BLACK; SIZE.width as usize];
        renderer.render_line(y as u32, &mut line);
        assert_eq!(shown.as_slice(), line, "line {y}");
    }
}
