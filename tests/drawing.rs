//! Pictures drawn step by step, in either order, on displays that fail.

#![allow(clippy::unwrap_used)]

#[path = "common/mirror_ball.rs"]
mod mirror_ball;

use std::collections::HashMap;

use embedded_graphics::Pixel;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{Gray2, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use fastrand::Rng;
use whitted::observer::Stats;
use whitted::render::{Output, RenderProgress, Step};
use whitted::{PreparedScene, Renderer, SceneBuffer};

use mirror_ball::SCENE;

/// Runs a test with the scene, ready to be traced.
fn with_scene(test: impl FnOnce(&PreparedScene<'_>)) {
    let mut buffer = SceneBuffer::<2, 1, 2>::new();
    test(&buffer.prepare(&SCENE).unwrap());
}

const ORDERS: [fn(Rectangle) -> RenderProgress; 2] =
    [RenderProgress::scanlines, RenderProgress::progressive];

/// Pictures and areas of them, some of which reach beyond or are outside.
fn areas() -> Vec<(Size, Rectangle)> {
    let area = |x, y, w, h| Rectangle::new(Point::new(x, y), Size::new(w, h));
    let mut areas = Vec::new();
    for (width, height) in [(1, 1), (1, 40), (17, 3), (16, 32), (33, 18), (70, 45)] {
        let size = Size::new(width, height);
        areas.push((size, Rectangle::new(Point::zero(), size)));
    }
    let size = Size::new(50, 40);
    for area in [
        area(3, 5, 20, 17),
        area(49, 39, 1, 1),
        area(-5, -7, 16, 16),
        area(40, 30, 30, 30),
        area(-100, -100, 1000, 1000),
        area(i32::MIN, i32::MIN, u32::MAX, u32::MAX),
        area(i32::MAX, 0, u32::MAX, 10),
        area(50, 0, 5, 5),
        area(-5, 0, 5, 5),
        area(0, -5, 5, 5),
        area(0, 0, 0, 5),
        area(10, 10, 7, 0),
    ] {
        areas.push((size, area));
    }
    areas
}

fn visible(size: Size, area: Rectangle) -> Vec<Point> {
    let left = |start: i32| i64::from(start).max(0);
    let right = |start: i32, length: u32, side: u32| {
        (i64::from(start) + i64::from(length)).min(side.into())
    };
    let mut points = Vec::new();
    for y in left(area.top_left.y)..right(area.top_left.y, area.size.height, size.height) {
        for x in left(area.top_left.x)..right(area.top_left.x, area.size.width, size.width) {
            points.push(Point::new(x as i32, y as i32));
        }
    }
    points
}

/// A call of the display that succeeded.
#[derive(Clone, Debug, PartialEq)]
enum Call {
    Fill(Rectangle, usize),
    Dots(Vec<Point>),
}

/// What a display shows, and what it was told.
#[derive(Default)]
struct Screen {
    shown: HashMap<Point, Rgb888>,
    /// All pixels of calls that succeeded, in their order.
    sent: Vec<(Point, Rgb888)>,
    calls: Vec<Call>,
    /// Of each call, whether it fails, and after how many pixels.
    fails: Option<Box<dyn FnMut() -> Option<usize>>>,
}

#[derive(Debug, PartialEq)]
struct Unplugged;

impl Screen {
    /// Each call fails once in so many, before or in the midst of its pixels.
    fn loose(mut rng: Rng, once_in: u32) -> Self {
        let fails = move || (rng.u32(0..once_in) == 0).then(|| rng.usize(0..20));
        Self {
            fails: Some(Box::new(fails)),
            ..Self::default()
        }
    }

    /// Only this call fails, after so many pixels.
    fn fails_at(call: usize, pixels: usize) -> Self {
        let mut calls = 0..;
        let fails = move || (calls.next() == Some(call)).then_some(pixels);
        Self {
            fails: Some(Box::new(fails)),
            ..Self::default()
        }
    }

    fn show(
        &mut self,
        pixels: impl Iterator<Item = (Point, Rgb888)>,
    ) -> Result<Vec<Point>, Unplugged> {
        let failure = self.fails.as_mut().and_then(|fails| fails());
        let before = self.sent.len();
        for (index, (point, color)) in pixels.enumerate() {
            if failure.is_some_and(|after| index >= after) {
                break;
            }
            self.shown.insert(point, color);
            self.sent.push((point, color));
        }
        if failure.is_some() {
            self.sent.truncate(before);
            return Err(Unplugged);
        }
        Ok(self.sent[before..]
            .iter()
            .map(|(point, _)| *point)
            .collect())
    }
}

impl OriginDimensions for Screen {
    fn size(&self) -> Size {
        Size::new(1000, 1000)
    }
}

impl DrawTarget for Screen {
    type Color = Rgb888;
    type Error = Unplugged;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Unplugged>
    where
        I: IntoIterator<Item = Pixel<Rgb888>>,
    {
        let pixels = pixels.into_iter().map(|Pixel(point, color)| (point, color));
        let points = self.show(pixels)?;
        self.calls.push(Call::Dots(points));
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Unplugged>
    where
        I: IntoIterator<Item = Rgb888>,
    {
        assert!(!area.is_zero_sized());
        let mut colors = colors.into_iter();
        let points = self.show(area.points().zip(&mut colors))?;
        assert_eq!(colors.next(), None, "more colors than pixels");
        self.calls.push(Call::Fill(*area, points.len()));
        Ok(())
    }
}

/// Draws to the end, each step being chosen anew, and returns how many failed.
fn draw(
    renderer: &mut Renderer<'_>,
    mut drawing: RenderProgress,
    screen: &mut Screen,
    mut step: impl FnMut() -> Step,
) -> usize {
    let mut failures = 0;
    while !drawing.is_complete() {
        let before = drawing;
        match renderer.step(&mut drawing, step(), screen) {
            Ok(()) => assert_ne!(drawing, before, "no step without progress"),
            Err(Unplugged) => failures += 1,
        }
    }
    failures
}

/// Line by line, without failure.
fn reference(scene: &PreparedScene<'_>, size: Size, drawing: RenderProgress) -> Screen {
    let mut screen = Screen::default();
    draw(
        &mut Renderer::new(scene, size),
        drawing,
        &mut screen,
        || Step::Line,
    );
    screen
}

fn any_step(rng: &mut Rng) -> Step {
    match rng.u8(0..12) {
        0 => Step::Pass,
        1..4 => Step::Line,
        _ => Step::Rays(rng.u32(1..200)),
    }
}

#[test]
fn both_orders_end_with_the_picture_and_trace_each_pixel_once() {
    let size = Size::new(320, 240);
    let whole = (size, Rectangle::new(Point::zero(), size));
    with_scene(|scene| {
        for (size, area) in areas().into_iter().chain([whole]) {
            let points = visible(size, area);
            let mut single = Renderer::new(scene, size);
            for order in ORDERS {
                let mut renderer = Renderer::with_observer(scene, size, Stats::default());
                let (mut screen, mut drawing) = (Screen::default(), order(area));
                while !drawing.is_complete() {
                    renderer
                        .step(&mut drawing, Step::Line, &mut screen)
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
                    let expected: Rgb888 = whitted::render::DisplayColor::from_radiance(
                        color,
                        *point,
                        Output::default(),
                    );
                    assert_eq!(screen.shown[point], expected, "{area:?} {point}");
                }
            }
        }
    });
}

#[test]
fn a_display_gets_the_same_pixels_however_a_drawing_is_stepped_and_whatever_fails() {
    let mut rng = Rng::with_seed(3);
    with_scene(|scene| {
        for (size, area) in areas() {
            for order in ORDERS {
                let reference = reference(scene, size, order(area));
                for once_in in [u32::MAX, 40, 5, 2] {
                    let mut screen = Screen::loose(rng.fork(), once_in);
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
fn each_call_may_fail() {
    let size = Size::new(35, 19);
    with_scene(|scene| {
        let mut renderer = Renderer::new(scene, size);
        for order in ORDERS {
            let drawing = order(Rectangle::new(Point::zero(), size));
            let reference = reference(scene, size, drawing);
            for step in [Step::Line, Step::Pass, Step::Rays(50)] {
                let mut call = 0;
                for pixels in [0, 1, 10, 1000].into_iter().cycle() {
                    let mut screen = Screen::fails_at(call, pixels);
                    let failures = draw(&mut renderer, drawing, &mut screen, || step);
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
fn a_failed_step_stays_after_the_last_call_that_succeeded() {
    let size = Size::new(64, 64);
    let area = Rectangle::new(Point::zero(), size);
    with_scene(|scene| {
        let mut renderer = Renderer::new(scene, size);
        let mut drawing = RenderProgress::progressive(area);
        let mut screen = Screen::fails_at(6, 100);
        let failed = renderer.step(&mut drawing, Step::Pass, &mut screen);
        assert_eq!(failed, Err(Unplugged));
        assert_eq!(screen.calls.len(), 6);

        let mut same = RenderProgress::progressive(area);
        renderer
            .step(&mut same, Step::Line, &mut Screen::default())
            .unwrap();
        for _ in 0..2 {
            assert_ne!(drawing, same);
            renderer
                .step(&mut same, Step::Rays(1), &mut Screen::default())
                .unwrap();
        }
        assert_eq!(drawing, same);
    });
}

#[test]
fn a_drawing_outlives_renderers_and_can_be_copied_moved_and_dropped() {
    let size = Size::new(40, 30);
    let area = Rectangle::new(Point::zero(), size);
    with_scene(|scene| {
        let expected = reference(scene, size, RenderProgress::progressive(area));
        let mut rng = Rng::with_seed(5);
        let (mut screen, mut drawing) = (Screen::default(), RenderProgress::progressive(area));
        while !drawing.is_complete() {
            // One that is given up does no harm.
            let mut other = Box::new(drawing);
            let mut elsewhere = Screen::default();
            Renderer::new(scene, size)
                .step(&mut other, any_step(&mut rng), &mut elsewhere)
                .unwrap();
            drop(other);

            let mut moved = drawing;
            Renderer::new(scene, size)
                .step(&mut moved, any_step(&mut rng), &mut screen)
                .unwrap();
            drawing = moved;
        }
        assert!(screen.sent == expected.sent);
    });
}

#[test]
fn the_first_pass_covers_everything() {
    with_scene(|scene| {
        for (size, area) in areas() {
            let points = visible(size, area);
            let mut renderer = Renderer::with_observer(scene, size, Stats::default());
            let (mut screen, mut drawing) = (Screen::default(), RenderProgress::progressive(area));
            renderer
                .step(&mut drawing, Step::Pass, &mut screen)
                .unwrap();
            assert_eq!(screen.sent.len(), points.len(), "{area:?}");
            assert!(points.iter().all(|point| screen.shown.contains_key(point)));
            let (Some(first), Some(last)) = (points.first(), points.last()) else {
                continue;
            };
            let blocks = |span: i32| span as u32 / 16 + 1;
            let count = blocks(last.x - first.x) * blocks(last.y - first.y);
            assert_eq!(renderer.observer().camera, count, "{area:?}");
        }
    });
}

/// Each call is one that a display's driver does well.
#[test]
fn the_calls_are_few() {
    let size = Size::new(40, 24);
    let all = Rectangle::new(Point::zero(), size);
    with_scene(|scene| {
        let mut calls = reference(scene, size, RenderProgress::progressive(all))
            .calls
            .into_iter();
        let mut fill = |x, y, width, height| {
            let area = Rectangle::new(Point::new(x, y), Size::new(width, height));
            let pixels = (width * height) as usize;
            assert_eq!(calls.next(), Some(Call::Fill(area, pixels)));
        };
        // Clipped at the right and at the bottom.
        for (y, height) in [(0, 16), (16, 8)] {
            for (x, width) in [(0, 16), (16, 16), (32, 8)] {
                fill(x, y, width, height);
            }
        }
        // All but the corner of each square of four.
        for (block, side) in [(8, 8), (4, 4), (2, 2)] {
            for y in (0..24).step_by(block) {
                let is_new = y as usize / block % 2 == 1;
                let first = if is_new { 0 } else { block };
                for x in (first..40).step_by(if is_new { block } else { 2 * block }) {
                    fill(x as i32, y, side, side);
                }
            }
        }
        for y in (0..24).step_by(2) {
            let dots = (1..40).step_by(2).map(|x| Point::new(x, y)).collect();
            assert_eq!(calls.next(), Some(Call::Dots(dots)));
            let line = Rectangle::new(Point::new(0, y + 1), Size::new(40, 1));
            assert_eq!(calls.next(), Some(Call::Fill(line, 40)));
        }
        assert_eq!(calls.next(), None);
    });
}

#[test]
fn a_pass_ends_with_its_blocks() {
    let size = Size::new(40, 24);
    let all = Rectangle::new(Point::zero(), size);
    with_scene(|scene| {
        let passes = |mut drawing: RenderProgress| {
            let mut renderer = Renderer::with_observer(scene, size, Stats::default());
            let mut pixels = Vec::new();
            while !drawing.is_complete() {
                let step = Step::Pass;
                renderer
                    .step(&mut drawing, step, &mut Screen::default())
                    .unwrap();
                pixels.push(renderer.observer().camera);
            }
            pixels
        };
        assert_eq!(passes(RenderProgress::scanlines(all)), [960]);
        assert_eq!(
            passes(RenderProgress::progressive(all)),
            [6, 15, 60, 240, 960]
        );
    });
}

/// A budget is spent, and no pixel more is begun.
#[test]
fn rays_are_counted_as_an_observer_does() {
    let size = Size::new(24, 20);
    let all = Rectangle::new(Point::zero(), size);
    let rays = |stats: &Stats| stats.camera + stats.reflected + stats.transmitted + stats.shadow;
    with_scene(|scene| {
        for order in ORDERS {
            let mut rng = Rng::with_seed(2);
            let mut renderer = Renderer::with_observer(scene, size, Stats::default());
            let (mut drawing, mut screen) = (order(all), Screen::default());
            while !drawing.is_complete() {
                let budget = rng.u32(0..30);
                let before = rays(renderer.observer());
                renderer
                    .step(&mut drawing, Step::Rays(budget), &mut screen)
                    .unwrap();
                let spent = rays(renderer.observer()) - before;
                // An eye ray, two mirrored ones, and a shadow ray each.
                assert!(spent < budget + 6, "{spent} of {budget}");
                assert!(spent >= budget || drawing.is_complete());
            }
            let (mut drawing, mut pixels) = (order(all), 0);
            while !drawing.is_complete() {
                let before = drawing;
                renderer
                    .step(&mut drawing, Step::Rays(0), &mut screen)
                    .unwrap();
                assert_eq!(drawing, before);
                renderer
                    .step(&mut drawing, Step::Rays(1), &mut screen)
                    .unwrap();
                pixels += 1;
            }
            assert_eq!(pixels, 24 * 20);
        }
    });
}

/// Smaller than the picture, and asks for no more than it can show.
struct Small(usize);

impl OriginDimensions for Small {
    fn size(&self) -> Size {
        Size::new(10, 10)
    }
}

impl DrawTarget for Small {
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
fn a_display_that_is_smaller_than_the_picture_does_not_hold_it_up() {
    let size = Size::new(40, 24);
    with_scene(|scene| {
        for order in ORDERS {
            let mut renderer = Renderer::new(scene, size);
            let mut drawing = order(Rectangle::new(Point::zero(), size));
            let mut small = Small(0);
            while !drawing.is_complete() {
                renderer
                    .step(&mut drawing, Step::Rays(3), &mut small)
                    .unwrap();
            }
            assert!(small.0 >= 100);
        }
    });
}

/// It would be another picture, but it ends.
#[test]
fn a_picture_may_shrink_and_grow() {
    let mut rng = Rng::with_seed(11);
    with_scene(|scene| {
        for order in ORDERS {
            for _ in 0..20 {
                let mut drawing = order(Rectangle::new(Point::new(3, 2), Size::new(50, 50)));
                while !drawing.is_complete() {
                    let size = Size::new(rng.u32(4..60), rng.u32(3..60));
                    Renderer::new(scene, size)
                        .step(&mut drawing, any_step(&mut rng), &mut Screen::default())
                        .unwrap();
                }
            }
        }
    });
}

/// A block shows the color of its first pixel, dithered as each pixel would be.
#[test]
fn blocks_are_dithered_pixel_by_pixel() {
    let size = Size::new(64, 64);
    let area = Rectangle::new(Point::new(5, 7), Size::new(50, 40));
    with_scene(|scene| {
        let mut renderer = Renderer::new(scene, size);
        let mut display = MockDisplay::<Gray2>::new();
        display.set_allow_overdraw(true);
        let mut drawing = RenderProgress::progressive(area);
        let mut mixed = 0;
        for block in [16, 8, 4, 2, 1] {
            assert_eq!(drawing.block(), block);
            renderer
                .step(&mut drawing, Step::Pass, &mut display)
                .unwrap();
            for point in area.points() {
                let corner = area.top_left + (point - area.top_left) / block as i32 * block as i32;
                let color = renderer.pixel(corner.x as u32, corner.y as u32);
                let expected =
                    whitted::render::DisplayColor::from_radiance(color, point, Output::default());
                assert_eq!(
                    display.get_pixel(point),
                    Some(expected),
                    "{point} of {block}"
                );
                mixed += usize::from(display.get_pixel(corner) != Some(expected));
            }
        }
        assert_eq!(drawing.block(), 0);
        assert!(mixed > 500, "{mixed}");
    });
}
