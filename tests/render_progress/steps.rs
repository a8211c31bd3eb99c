//! Steps: every pixel is traced once and sent once, whatever the steps and failures.

use embedded_graphics::Pixel;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use fastrand::Rng;
use whitted::Renderer;
use whitted::observer::Stats;
use whitted::render::{DisplayColor, Output, RenderProgress, Step};

use super::screen::{Screen, Unplugged};
use super::{ORDERS, any_step, areas, draw, reference, visible, with_scene};

#[test]
fn both_orders_trace_each_pixel_once() {
    let size = Size::new(320, 240);
    let whole = (size, Rectangle::new(Point::zero(), size));
    with_scene(|scene| {
        for (size, area) in areas().into_iter().chain([whole]) {
            let points = visible(size, area);
            let mut single = Renderer::new(scene, size);
            for order in ORDERS {
                let mut renderer = Renderer::with_observer(scene, size, Stats::default());
                let (mut screen, mut progress) = (Screen::default(), order(area));
                while !progress.is_complete() {
                    renderer
                        .step(&mut progress, Step::Line, &mut screen)
                        .unwrap();
                }
                assert_eq!(
                    renderer.observer().camera as usize,
                    points.len(),
                    "{area:?}"
                );
                assert_eq!(screen.shown.len(), points.len(), "{area:?}");
                for point in &points {
                    let color = single.pixel(point.x as u32, point.y as u32);
                    let expected: Rgb888 =
                        DisplayColor::from_radiance(color, *point, Output::default());
                    assert_eq!(screen.shown[point], expected, "{area:?} {point}");
                }
            }
        }
    });
}

#[test]
fn pixels_do_not_depend_on_steps_or_failures() {
    let mut rng = Rng::with_seed(3);
    with_scene(|scene| {
        for (size, area) in areas() {
            for order in ORDERS {
                let reference = reference(scene, size, order(area));
                for once_in in [u32::MAX, 40, 5, 2] {
                    let mut screen = Screen::failing_at_random(rng.fork(), once_in);
                    let renderer = &mut Renderer::new(scene, size);
                    draw(renderer, order(area), &mut screen, || any_step(&mut rng));
                    assert!(screen.sent == reference.sent, "{area:?}");
                    assert!(screen.shown == reference.shown, "{area:?}");
                }
            }
        }
    });
}

#[test]
fn resumes_after_failure_of_any_call() {
    let size = Size::new(35, 19);
    with_scene(|scene| {
        let mut renderer = Renderer::new(scene, size);
        for order in ORDERS {
            let progress = order(Rectangle::new(Point::zero(), size));
            let reference = reference(scene, size, progress);
            for step in [Step::Line, Step::Pass, Step::Rays(50)] {
                let mut call = 0;
                for pixels in [0, 1, 10, 1000].into_iter().cycle() {
                    let mut screen = Screen::failing_at(call, pixels);
                    let failures = draw(&mut renderer, progress, &mut screen, || step);
                    assert!(screen.sent == reference.sent, "{step:?} {call}");
                    assert!(screen.shown == reference.shown, "{step:?} {call}");
                    if failures == 0 {
                        break;
                    }
                    assert_eq!(failures, 1);
                    call += 1;
                }
                assert!(call >= 19, "{call} calls");
            }
        }
    });
}

#[test]
fn failed_step_keeps_progress_of_successful_calls() {
    let size = Size::new(64, 64);
    let area = Rectangle::new(Point::zero(), size);
    with_scene(|scene| {
        let mut renderer = Renderer::new(scene, size);
        let mut progress = RenderProgress::progressive(area);
        let mut screen = Screen::failing_at(6, 100);
        let failed = renderer.step(&mut progress, Step::Pass, &mut screen);
        assert_eq!(failed, Err(Unplugged));
        assert_eq!(screen.calls.len(), 6);

        let mut expected = RenderProgress::progressive(area);
        renderer
            .step(&mut expected, Step::Line, &mut Screen::default())
            .unwrap();
        for _ in 0..2 {
            assert_ne!(progress, expected);
            renderer
                .step(&mut expected, Step::Rays(1), &mut Screen::default())
                .unwrap();
        }
        assert_eq!(progress, expected);
    });
}

#[test]
fn progress_outlives_renderer_and_can_be_copied() {
    let size = Size::new(40, 30);
    let area = Rectangle::new(Point::zero(), size);
    with_scene(|scene| {
        let expected = reference(scene, size, RenderProgress::progressive(area));
        let mut rng = Rng::with_seed(5);
        let (mut screen, mut progress) = (Screen::default(), RenderProgress::progressive(area));
        while !progress.is_complete() {
            // Dropping a copy must not affect the original.
            let mut other = Box::new(progress);
            let mut elsewhere = Screen::default();
            Renderer::new(scene, size)
                .step(&mut other, any_step(&mut rng), &mut elsewhere)
                .unwrap();
            drop(other);

            let mut moved = progress;
            Renderer::new(scene, size)
                .step(&mut moved, any_step(&mut rng), &mut screen)
                .unwrap();
            progress = moved;
        }
        assert!(screen.sent == expected.sent);
    });
}

/// `Step::Rays` ends with the first pixel that exhausts its budget.
#[test]
fn ray_budget_matches_observer_count() {
    let size = Size::new(24, 20);
    let all = Rectangle::new(Point::zero(), size);
    let rays = |stats: &Stats| stats.camera + stats.reflected + stats.transmitted + stats.shadow;
    with_scene(|scene| {
        for order in ORDERS {
            let mut rng = Rng::with_seed(2);
            let mut renderer = Renderer::with_observer(scene, size, Stats::default());
            let (mut progress, mut screen) = (order(all), Screen::default());
            while !progress.is_complete() {
                let budget = rng.u32(0..30);
                let before = rays(renderer.observer());
                renderer
                    .step(&mut progress, Step::Rays(budget), &mut screen)
                    .unwrap();
                let spent = rays(renderer.observer()) - before;
                // A pixel takes a camera ray, two reflected ones and a shadow ray for
                // each: six rays at most.
                assert!(spent < budget + 6, "{spent} of {budget}");
                assert!(spent >= budget || progress.is_complete());
            }
            let (mut progress, mut pixels) = (order(all), 0);
            while !progress.is_complete() {
                let before = progress;
                renderer
                    .step(&mut progress, Step::Rays(0), &mut screen)
                    .unwrap();
                assert_eq!(progress, before);
                renderer
                    .step(&mut progress, Step::Rays(1), &mut screen)
                    .unwrap();
                pixels += 1;
            }
            assert_eq!(pixels, 24 * 20);
        }
    });
}

/// Display smaller than the picture, which stops reading at the first pixel outside.
/// Counts the pixels inside.
struct SmallDisplay(usize);

impl OriginDimensions for SmallDisplay {
    fn size(&self) -> Size {
        Size::new(10, 10)
    }
}

impl DrawTarget for SmallDisplay {
    type Color = Rgb888;
    type Error = Unplugged;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Unplugged>
    where
        I: IntoIterator<Item = Pixel<Rgb888>>,
    {
        let area = self.bounding_box();
        let pixels = pixels.into_iter();
        self.0 += pixels
            .take_while(|Pixel(point, _)| area.contains(*point))
            .count();
        Ok(())
    }
}

#[test]
fn completes_on_display_smaller_than_picture() {
    let size = Size::new(40, 24);
    with_scene(|scene| {
        for order in ORDERS {
            let mut renderer = Renderer::new(scene, size);
            let mut progress = order(Rectangle::new(Point::zero(), size));
            let mut small = SmallDisplay(0);
            while !progress.is_complete() {
                renderer
                    .step(&mut progress, Step::Rays(3), &mut small)
                    .unwrap();
            }
            assert!(small.0 >= 100);
        }
    });
}

/// A change of the picture size on the way gives a mixed picture, but must not
/// prevent completion.
#[test]
fn completes_if_picture_size_changes() {
    let mut rng = Rng::with_seed(11);
    with_scene(|scene| {
        for order in ORDERS {
            for _ in 0..20 {
                let mut progress = order(Rectangle::new(Point::new(3, 2), Size::new(50, 50)));
                while !progress.is_complete() {
                    let size = Size::new(rng.u32(4..60), rng.u32(3..60));
                    Renderer::new(scene, size)
                        .step(&mut progress, any_step(&mut rng), &mut Screen::default())
                        .unwrap();
                }
            }
        }
    });
}
