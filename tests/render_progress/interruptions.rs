//! Observers that interrupt the renderer inside a pixel.

use std::ops::ControlFlow;

use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use fastrand::Rng;
use whitted::observer::{Observer, Poller, RayKind, ShapeKind};
use whitted::render::{AaSample, AntialiasedRenderer, SampleCount, Step};
use whitted::{
    Background, Camera, Color, Light, Material, MaterialId, Object, Real, Renderer, Scene,
    SceneBuffer, Vec3, real, vec3,
};

use super::screen::Screen;
use super::{ORDERS, any_step, areas, reference, with_scene};

/// Two glass sphereflakes of the greatest depth. Their ray trees are too large to trace.
const SLOW: Scene = Scene {
    background: Background::Solid(Color::gray(Real::ONE)),
    lights: &[LIGHT, LIGHT],
    materials: &[Material {
        kd: Color::gray(Real::ONE),
        kr: Color::gray(Real::ONE),
        kt: Color::gray(Real::ONE),
        ..Material::BLACK
    }],
    objects: &[flake("0"), flake("0.5")],
    min_weight: Real::ZERO,
    max_depth: 32,
    ..Scene::new(Camera::new(vec3!(0.1, 0.2, 4), vec3!(0, 0, 0), real!(33)))
};

const LIGHT: Light = Light::point(vec3!(-3, 4, 3), Color::gray(Real::ONE));

const fn flake(x: &str) -> Object {
    Object::sphereflake(Vec3::lit(x, "0", "0"), real!(0.5), 8, MaterialId(0))
}

/// Interrupts the renderer after `limit` rays and tests.
struct Limit {
    limit: u32,
    count: u32,
}

impl Observer for Limit {
    fn ray(&mut self, _: RayKind) {
        self.count += 1;
    }

    fn test(&mut self, _: ShapeKind, _: bool) {
        self.count += 1;
    }

    fn is_interrupted(&self) -> bool {
        self.count >= self.limit
    }
}

#[test]
fn interrupted_pictures_are_completed() {
    let mut rng = Rng::with_seed(19);
    with_scene(|scene| {
        let mut interruptions = 0;
        for (size, area) in areas() {
            for order in ORDERS {
                let expected = reference(scene, size, order(area));
                let mut screen = Screen::failing_at_random(rng.fork(), 20);
                let mut progress = order(area);
                while !progress.is_complete() {
                    let poller = Poller::new(rng.u32(0..100), || ControlFlow::Break(()));
                    let mut renderer = Renderer::with_observer(scene, size, poller);
                    for _ in 0..3 {
                        _ = renderer.step(&mut progress, any_step(&mut rng), &mut screen);
                        interruptions += u32::from(renderer.observer().is_interrupted());
                        renderer.observer_mut().resume();
                    }
                }
                assert!(screen.sent == expected.sent, "{area:?}");
                assert!(screen.shown == expected.shown, "{area:?}");
            }
        }
        assert!(interruptions > 500, "{interruptions}");
    });
}

#[test]
fn slow_pixels_end_at_an_interruption() {
    let mut buffer = SceneBuffer::<2, 2, 1>::new();
    let scene = buffer.prepare(&SLOW).unwrap();
    let size = Size::new(33, 21);
    let all = Rectangle::new(Point::zero(), size);
    let mut rng = Rng::with_seed(3);
    for order in ORDERS {
        for _ in 0..200 {
            let limit = rng.u32(1..20_000);
            let mut renderer = Renderer::with_observer(&scene, size, Limit { limit, count: 0 });
            let (mut progress, mut screen) = (order(all), Screen::default());
            renderer
                .step(&mut progress, Step::Pass, &mut screen)
                .unwrap();
            assert!(!progress.is_complete());
            // At most one test of each of the two flakes, for the ray and for the two lights, and
            // the two shadow rays.
            let count = renderer.observer().count;
            assert!((limit..=limit + 8).contains(&count), "{count} of {limit}");
        }
    }
}

#[test]
fn lines_end_at_an_interruption() {
    let size = Size::new(40, 30);
    with_scene(|scene| {
        let expected: Vec<_> = Renderer::new(scene, size).line(15).collect();
        let limit = |limit| Renderer::with_observer(scene, size, Limit { limit, count: 0 });
        let mut lengths = Vec::new();
        for units in (1..1000).step_by(7) {
            let line: Vec<_> = limit(units).line(15).collect();
            assert_eq!(line, expected[..line.len()]);
            let mut slice = [Color::<u16>::default(); 40];
            limit(units).render_line(15, &mut slice);
            let rest = &slice[line.len()..];
            assert!(rest.iter().all(|pixel| *pixel == Color::default()));
            lengths.push(line.len());
        }
        assert!(lengths.is_sorted() && lengths.first() == Some(&0));
        assert_eq!(lengths.last(), Some(&40));
        assert_eq!(limit(1).pixel(20, 15), Color::default());
    });
}

#[test]
fn antialiased_lines_can_be_repeated() {
    let size = Size::new(40, 30);
    with_scene(|scene| {
        let mut memory = [AaSample::BLACK; 80];
        let samples = SampleCount::Four;
        let mut whole = AntialiasedRenderer::new(scene, size, samples, &mut memory).unwrap();
        let expected: Vec<Vec<_>> = (0..30).map(|y| whole.line(y).collect()).collect();

        let mut memory = [AaSample::BLACK; 80];
        let mut calls = 0;
        let poller = Poller::new(500, || {
            calls += 1;
            // The interruptions become rarer, so that each line is finished at some time.
            match calls % (1 + calls / 20) {
                0 => ControlFlow::Break(()),
                _ => ControlFlow::Continue(()),
            }
        });
        let mut renderer =
            AntialiasedRenderer::with_observer(scene, size, samples, &mut memory, poller).unwrap();
        let mut interruptions = 0;
        for y in 0..30 {
            loop {
                let line: Vec<_> = renderer.line(y).collect();
                if !renderer.observer().is_interrupted() {
                    assert_eq!(line, expected[y as usize]);
                    break;
                }
                assert!(line.is_empty());
                renderer.observer_mut().resume();
                interruptions += 1;
            }
        }
        assert!(interruptions > 20, "{interruptions}");
    });
}

/// The function is called after each interval, whatever the methods that draw. After an
/// interruption, it is not called until drawing resumes.
#[test]
fn poller_counts_rays_and_tests() {
    let size = Size::new(40, 30);
    with_scene(|scene| {
        let unlimited = Limit {
            limit: u32::MAX,
            count: 0,
        };
        let mut renderer = Renderer::with_observer(scene, size, unlimited);
        renderer.draw(&mut Screen::default()).unwrap();
        let units = renderer.observer().count;
        for interval in [0, 1, 7, 100, units, units + 1] {
            let mut calls = 0;
            let poller = Poller::new(interval, || {
                calls += 1;
                ControlFlow::Continue(())
            });
            let mut renderer = Renderer::with_observer(scene, size, poller);
            renderer.draw(&mut Screen::default()).unwrap();
            assert!(!renderer.observer().is_interrupted());
            assert_eq!(calls, units / interval.max(1));
        }
        let mut calls = 0;
        let poller = Poller::new(10, || {
            calls += 1;
            ControlFlow::Break(())
        });
        let mut renderer = Renderer::with_observer(scene, size, poller);
        for y in 0..30 {
            assert_eq!(renderer.line(y).count() == 0, y > 0);
        }
        assert_eq!(calls, 1);
    });
}
