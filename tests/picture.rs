//! Pictures at any position on any target, opaque and transparent.

use std::cell::RefCell;

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use whitted::observer::{Observer, RayNode, Stats};
use whitted::render::{
    AaSample, AntialiasedRenderer, DirtyLines, Picture, RenderProgress, SampleCount, Step,
};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, PreparedScene, Real, Renderer,
    Scene, SceneBuffer, color, real, vec3,
};

use crate::common::mirror_ball;
use crate::common::window::Window;

const SIZE: Size = Size::new(64, 48);

/// Origins of displays: the usual one, the middle, and points outside the picture.
const ORIGINS: [Point; 5] = [
    Point::new(0, 0),
    Point::new(-32, -24),
    Point::new(5, 7),
    Point::new(100, 100),
    Point::new(-70_000, 70_000),
];

/// A mirror ball in front of a gray background, without a floor.
static BALL: Scene = Scene {
    lights: &[Light::point(vec3!(-6, 11, 7), Color::gray(Real::ONE))],
    materials: &[Material {
        kd: color!(0.6, 0.04, 0.03),
        kr: color!(0.3, 0.3, 0.3),
        ..Material::BLACK
    }],
    objects: &[Object::sphere(vec3!(0, 1, 0), real!(1), MaterialId(0))],
    background: Background::Solid(color!(0.3, 0.3, 0.3)),
    ..Scene::new(Camera::new(vec3!(0, 2, 8), vec3!(0, 1, 0), real!(33)))
};

type Buffer = SceneBuffer<2, 1, 2>;

/// A way to draw on a display.
type Way<'s> = Box<dyn FnMut(&mut Window) + 's>;

/// Draws with renderers of the size of the display, once in each way.
fn draw_in_each_way(scene: &PreparedScene<'_>, origin: Point) -> Vec<Window> {
    let mut ways: Vec<Way<'_>> = vec![
        Box::new(|it| Renderer::new(scene, SIZE).draw(it).unwrap()),
        Box::new(|it| {
            let mut renderer = Renderer::new(scene, SIZE);
            (0..48).for_each(|y| renderer.draw_line(y, it).unwrap());
        }),
        Box::new(|it| {
            let mut progress = RenderProgress::progressive(it.bounding_box());
            let mut renderer = Renderer::new(scene, SIZE);
            while !progress.is_complete() {
                renderer.step(&mut progress, Step::Rays(800), it).unwrap();
            }
        }),
        Box::new(|it| {
            let mut hashes = [0; DirtyLines::hashes(SIZE)];
            let mut lines = DirtyLines::new(SIZE.width, &mut hashes);
            let mut line = [Rgb565::BLACK; SIZE.width as usize];
            for y in 0..SIZE.height {
                Renderer::new(scene, SIZE).render_line(y, &mut line);
                lines.send_line(y, &line, it).unwrap();
            }
        }),
        Box::new(|it| {
            let mut memory = [AaSample::BLACK; 2 * 64];
            AntialiasedRenderer::new(scene, SIZE, SampleCount::Four, &mut memory)
                .unwrap()
                .draw(it)
                .unwrap();
        }),
    ];
    let draw = |way: &mut Way<'_>| {
        let mut window = Window::new(origin, SIZE);
        way(&mut window);
        window
    };
    ways.iter_mut().map(draw).collect()
}

#[test]
fn renderers_fill_a_display_wherever_its_pixels_are_counted_from() {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&mirror_ball::SCENE).unwrap();
    let usual = draw_in_each_way(&scene, Point::zero());
    for origin in ORIGINS {
        for (window, usual) in draw_in_each_way(&scene, origin).iter().zip(&usual) {
            assert!(window.pixels.iter().all(Option::is_some), "{origin}");
            assert_eq!(window.pixels, usual.pixels, "{origin}");
        }
    }
}

/// Draws a picture on a whole display, at (0, 0). Returns the result for other displays to
/// compare with.
fn reference(picture: &impl Drawable<Color = Rgb565, Output = ()>) -> Window {
    let mut window = Window::new(Point::zero(), SIZE);
    picture.draw(&mut window).unwrap();
    window
}

/// Checks the pixels of a display on which the picture is drawn at a position. Only the pixels in
/// `visible` may be drawn.
#[track_caller]
fn assert_shows(window: &Window, reference: &Window, position: Point, visible: Rectangle) {
    for at in window.bounding_box().points() {
        let expected = match visible.contains(at) {
            true => reference.get(at - position),
            false => None,
        };
        assert_eq!(
            window.get(at),
            expected,
            "pixel {at}, picture at {position}"
        );
    }
}

/// Calls a function with an opaque and a transparent picture, with and without smooth edges.
macro_rules! for_each_kind {
    ($scene:expr, $position:expr, $picture:ident => $check:expr) => {
        let memory = RefCell::new([AaSample::BLACK; 2 * 64]);
        let opaque = |at| Picture::new($scene, at, SIZE);
        {
            let $picture = |at| opaque(at);
            $check
        }
        {
            let $picture = |at| opaque(at).transparent();
            $check
        }
        {
            let $picture = |at| opaque(at).antialiased(SampleCount::Four, &memory).unwrap();
            $check
        }
        {
            let smooth = |at| {
                opaque(at)
                    .transparent()
                    .antialiased(SampleCount::Four, &memory)
            };
            let $picture = |at| smooth(at).unwrap();
            $check
        }
    };
}

#[test]
fn pictures_can_lie_anywhere() {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&BALL).unwrap();
    let positions = [
        (0, 0),
        (3, 5),
        (-20, -10),
        (40, 30),
        (-64, 0),
        (90_000, -90_000),
    ];
    for position in positions.map(|(x, y)| Point::new(x, y)) {
        for_each_kind!(&scene, position, picture => {
            let reference = reference(&picture(Point::zero()));
            for origin in ORIGINS {
                let mut window = Window::new(origin, SIZE);
                let everything = window.bounding_box();
                picture(position + origin).draw(&mut window).unwrap();
                assert_shows(&window, &reference, position + origin, everything);
            }
        });
    }
}

#[test]
fn pictures_can_be_clipped_cropped_and_translated() {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&BALL).unwrap();
    let area = Rectangle::new(Point::new(15, 9), Size::new(31, 29));
    for_each_kind!(&scene, Point::zero(), picture => {
        let reference = reference(&picture(Point::zero()));

        let mut window = Window::new(Point::zero(), SIZE);
        picture(Point::zero()).draw(&mut window.clipped(&area)).unwrap();
        assert_shows(&window, &reference, Point::zero(), area);

        let mut window = Window::new(Point::zero(), SIZE);
        picture(Point::zero()).draw(&mut window.cropped(&area)).unwrap();
        assert_shows(&window, &reference, area.top_left, area);

        let by = Point::new(7, -4);
        let mut window = Window::new(Point::zero(), SIZE);
        let everything = window.bounding_box();
        picture(Point::zero()).draw(&mut window.translated(by)).unwrap();
        assert_shows(&window, &reference, by, everything);

        let mut window = Window::new(Point::zero(), SIZE);
        picture(Point::zero()).translate(by).draw(&mut window).unwrap();
        assert_shows(&window, &reference, by, everything);
        let mut moved = picture(Point::zero());
        moved.translate_mut(by);
        assert_eq!(moved.bounding_box(), Rectangle::new(by, SIZE));
    });
}

/// Pixels whose center ray misses every object, found by an observer.
fn misses(scene: &PreparedScene<'_>) -> Vec<bool> {
    #[derive(Default)]
    struct IsMiss(bool);
    impl Observer for IsMiss {
        fn node(&mut self, node: &RayNode) {
            if node.generation == 0 {
                self.0 = node.object.is_none();
            }
        }
    }
    let mut renderer = Renderer::with_observer(scene, SIZE, IsMiss::default());
    let mut misses = Vec::new();
    for y in 0..SIZE.height {
        for x in 0..SIZE.width {
            renderer.pixel(x, y);
            misses.push(renderer.observer().0);
        }
    }
    misses
}

#[test]
fn transparent_pictures_draw_only_pixels_whose_ray_hits_an_object() {
    for scene in [&BALL, &mirror_ball::SCENE] {
        let mut buffer = Buffer::new();
        let scene = buffer.prepare(scene).unwrap();
        let misses = misses(&scene);
        assert!(misses.contains(&false));
        let memory = RefCell::new([AaSample::BLACK; 2 * 64]);
        let picture = Picture::new(&scene, Point::zero(), SIZE);
        let smooth = picture.antialiased(SampleCount::Four, &memory).unwrap();
        let pairs = [
            (reference(&picture), reference(&picture.transparent())),
            (
                reference(&smooth),
                reference(
                    &picture
                        .transparent()
                        .antialiased(SampleCount::Four, &memory)
                        .unwrap(),
                ),
            ),
        ];
        for (opaque, transparent) in pairs {
            for (index, is_miss) in misses.iter().enumerate() {
                let expected = opaque.pixels[index].filter(|_| !is_miss);
                assert_eq!(transparent.pixels[index], expected, "pixel {index}");
            }
        }
    }
}

#[test]
fn steps_draw_the_picture_at_its_position() {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&BALL).unwrap();
    let position = Point::new(-9, 11);
    for step in [Step::Line, Step::Pass, Step::Rays(70)] {
        let opaque = Picture::new(&scene, position, SIZE);
        let transparent = opaque.transparent();
        for start in [RenderProgress::scanlines, RenderProgress::progressive] {
            let (mut expected, mut window) = (
                Window::new(Point::zero(), SIZE),
                Window::new(Point::zero(), SIZE),
            );
            opaque.draw(&mut expected).unwrap();
            let mut progress = start(opaque.bounding_box());
            while !progress.is_complete() {
                opaque.step(&mut progress, step, &mut window).unwrap();
            }
            assert_eq!(window, expected);

            let (mut expected, mut window) = (
                Window::new(Point::zero(), SIZE),
                Window::new(Point::zero(), SIZE),
            );
            transparent.draw(&mut expected).unwrap();
            let mut progress = start(transparent.bounding_box());
            while !progress.is_complete() {
                transparent.step(&mut progress, step, &mut window).unwrap();
                for (drawn, final_color) in window.pixels.iter().zip(&expected.pixels) {
                    assert!(
                        drawn.is_none() || drawn == final_color,
                        "a pixel behind is covered"
                    );
                }
            }
            assert_eq!(window, expected);
        }
    }
}

#[test]
fn rays_are_traced_for_visible_pixels_only() {
    let mut buffer = Buffer::new();
    let scene = buffer.prepare(&BALL).unwrap();
    let mut window = Window::new(Point::new(3, 4), Size::new(20, 10));
    let mut renderer = Renderer::with_observer(&scene, SIZE, Stats::default());
    renderer.draw(&mut window).unwrap();
    assert_eq!(renderer.observer().camera, 20 * 10);

    let mut memory = [AaSample::BLACK; 2 * 64];
    let (four, stats) = (SampleCount::Four, Stats::default());
    let mut renderer =
        AntialiasedRenderer::with_observer(&scene, SIZE, four, &mut memory, stats).unwrap();
    renderer.draw(&mut window).unwrap();
    // One column and one line next to the visible pixels are traced too. No edge is visible.
    assert_eq!(renderer.observer().camera, 21 * 11);
    // The next line is drawn in full width again.
    assert_eq!(renderer.line(3).count(), 64);
}
