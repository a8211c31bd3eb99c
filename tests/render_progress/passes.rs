//! Passes of the progressive order: their blocks, calls and dithering.

use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::Gray2;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use whitted::Renderer;
use whitted::observer::Stats;
use whitted::render::{DisplayColor, Output, RenderProgress, Step};

use super::screen::{Call, Screen};
use super::{areas, reference, visible, with_scene};

#[test]
fn first_pass_covers_the_area_with_blocks() {
    with_scene(|scene| {
        for (size, area) in areas() {
            let points = visible(size, area);
            let mut renderer = Renderer::with_observer(scene, size, Stats::default());
            let (mut screen, mut progress) = (Screen::default(), RenderProgress::progressive(area));
            renderer
                .step(&mut progress, Step::Pass, &mut screen)
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

/// Blocks and lines must go out as `fill_contiguous`, which display drivers turn
/// into one burst; only the last pass draws single pixels.
#[test]
fn progressive_calls_are_fills_and_rows_of_dots() {
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
        // First pass: blocks of 16x16, clipped at the right and at the bottom.
        for (y, height) in [(0, 16), (16, 8)] {
            for (x, width) in [(0, 16), (16, 16), (32, 8)] {
                fill(x, y, width, height);
            }
        }
        // Later passes: three of four blocks; the first one is on the display already.
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
fn pass_steps_trace_one_block_size() {
    let size = Size::new(40, 24);
    let all = Rectangle::new(Point::zero(), size);
    with_scene(|scene| {
        let passes = |mut progress: RenderProgress| {
            let mut renderer = Renderer::with_observer(scene, size, Stats::default());
            let mut pixels = Vec::new();
            while !progress.is_complete() {
                let step = Step::Pass;
                renderer
                    .step(&mut progress, step, &mut Screen::default())
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

/// A block has the radiance of its top left pixel, dithered by the position of each
/// pixel.
#[test]
fn blocks_are_dithered_per_pixel() {
    let size = Size::new(64, 64);
    let area = Rectangle::new(Point::new(5, 7), Size::new(50, 40));
    with_scene(|scene| {
        let mut renderer = Renderer::new(scene, size);
        let mut display = MockDisplay::<Gray2>::new();
        display.set_allow_overdraw(true);
        let mut progress = RenderProgress::progressive(area);
        let mut mixed = 0;
        for block in [16, 8, 4, 2, 1] {
            assert_eq!(progress.block(), block);
            renderer
                .step(&mut progress, Step::Pass, &mut display)
                .unwrap();
            for point in area.points() {
                let corner = area.top_left + (point - area.top_left) / block as i32 * block as i32;
                let color = renderer.pixel(corner.x as u32, corner.y as u32);
                let expected = DisplayColor::from_radiance(color, point, Output::default());
                assert_eq!(
                    display.get_pixel(point),
                    Some(expected),
                    "{point} of {block}"
                );
                mixed += usize::from(display.get_pixel(corner) != Some(expected));
            }
        }
        assert_eq!(progress.block(), 0);
        assert!(mixed > 500, "{mixed}");
    });
}
