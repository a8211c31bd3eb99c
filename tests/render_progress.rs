//! `RenderProgress`: pictures drawn in steps, in scanline and in progressive order,
//! on displays that fail.

mod interruptions;
mod passes;
mod screen;
mod steps;

use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use fastrand::Rng;
use whitted::render::{RenderProgress, Step};
use whitted::{PreparedScene, Renderer, SceneBuffer};

use crate::common::mirror_ball::SCENE;
use screen::{Screen, Unplugged};

/// Runs a test with the prepared scene.
fn with_scene(test: impl FnOnce(&PreparedScene<'_>)) {
    let mut buffer = SceneBuffer::<2, 1, 2>::new();
    test(&buffer.prepare(&SCENE).unwrap());
}

const ORDERS: [fn(Rectangle) -> RenderProgress; 2] =
    [RenderProgress::scanlines, RenderProgress::progressive];

/// Returns picture sizes and areas, some of them partly or completely outside the
/// picture.
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

/// Returns the points of an area that are inside the picture, row by row.
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

/// Draws to the end, with a step from `step` each time. Returns the number of
/// failures.
fn draw(
    renderer: &mut Renderer<'_>,
    mut progress: RenderProgress,
    screen: &mut Screen,
    mut step: impl FnMut() -> Step,
) -> usize {
    let mut failures = 0;
    while !progress.is_complete() {
        let before = progress;
        match renderer.step(&mut progress, step(), screen) {
            Ok(()) => assert_ne!(progress, before, "a step made no progress"),
            Err(Unplugged) => failures += 1,
        }
    }
    failures
}

/// Draws line by line, without failures.
fn reference(scene: &PreparedScene<'_>, size: Size, progress: RenderProgress) -> Screen {
    let mut screen = Screen::default();
    draw(
        &mut Renderer::new(scene, size),
        progress,
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
