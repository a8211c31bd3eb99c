//! Contract between the renderer and its `DrawTarget`: calls, errors and observers.

use std::convert::Infallible;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666,
    Rgb888,
};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use whitted::observer::{Observer, RayKind, Stats};
use whitted::{Renderer, SceneBuffer};

use crate::common::line_display::{LineDisplay, Unplugged};
use crate::common::mirror_ball::SCENE;

/// Checks that a picture is drawn completely. `MockDisplay` panics if a pixel is
/// drawn twice or lies outside the display.
fn assert_draws_every_pixel_once<C>(size: Size)
where
    C: PixelColor + whitted::render::DisplayColor,
    MockDisplay<C>: DrawTarget<Color = C, Error = Infallible>,
{
    let mut buffer = SceneBuffer::<2, 1, 2>::new();
    let scene = buffer.prepare(&SCENE).unwrap();
    let mut display = MockDisplay::<C>::new();
    Renderer::new(&scene, size).draw(&mut display).unwrap();
    let drawn = Rectangle::new(Point::zero(), size);
    for point in display.bounding_box().points() {
        assert_eq!(
            display.get_pixel(point).is_some(),
            drawn.contains(point),
            "{point}"
        );
    }
}

#[test]
fn draws_every_pixel_once_in_every_color_type() {
    let size = Size::new(33, 17);
    assert_draws_every_pixel_once::<Rgb555>(size);
    assert_draws_every_pixel_once::<Rgb565>(size);
    assert_draws_every_pixel_once::<Rgb666>(size);
    assert_draws_every_pixel_once::<Rgb888>(size);
    assert_draws_every_pixel_once::<Bgr555>(size);
    assert_draws_every_pixel_once::<Bgr565>(size);
    assert_draws_every_pixel_once::<Bgr666>(size);
    assert_draws_every_pixel_once::<Bgr888>(size);
    assert_draws_every_pixel_once::<Gray8>(size);
    assert_draws_every_pixel_once::<Gray4>(size);
    assert_draws_every_pixel_once::<Gray2>(size);
    assert_draws_every_pixel_once::<BinaryColor>(size);
}

#[test]
fn accepts_every_size() {
    for (width, height) in [(0, 0), (0, 5), (5, 0), (1, 1), (64, 1), (1, 64), (64, 64)] {
        assert_draws_every_pixel_once::<Gray8>(Size::new(width, height));
    }
}

#[test]
fn draws_each_line_by_one_fill_contiguous() {
    let mut buffer = SceneBuffer::<2, 1, 2>::new();
    let scene = buffer.prepare(&SCENE).unwrap();
    let mut display = LineDisplay::default();
    let mut renderer = Renderer::new(&scene, display.size());
    renderer.draw(&mut display).unwrap();
    assert_eq!(display.lines.len(), 30);
    for (y, (area, colors)) in (0..).zip(&display.lines) {
        assert_eq!(*area, Rectangle::new(Point::new(0, y), Size::new(40, 1)));
        // `render_line` must give the same colors.
        let mut line = [Rgb888::BLACK; 40];
        renderer.render_line(y as u32, &mut line);
        assert_eq!(colors.as_slice(), line);
    }
}

#[test]
fn returns_display_error_and_can_redraw_the_line() {
    let mut buffer = SceneBuffer::<2, 1, 2>::new();
    let scene = buffer.prepare(&SCENE).unwrap();
    let mut whole = LineDisplay::default();
    Renderer::new(&scene, whole.size())
        .draw(&mut whole)
        .unwrap();

    // Failures at the start of every line, and after every pixel of line 7.
    for (call, pixels) in (0..30).map(|call| (call, 0)).chain((0..40).map(|n| (7, n))) {
        let mut display = LineDisplay {
            fails_at: Some((call, pixels)),
            ..LineDisplay::default()
        };
        let mut renderer = Renderer::new(&scene, display.size());
        assert_eq!(renderer.draw(&mut display), Err(Unplugged));
        assert_eq!(display.lines.len(), call);
        display.fails_at = None;
        (call as u32..30)
            .try_for_each(|y| renderer.draw_line(y, &mut display))
            .unwrap();
        assert!(display.lines == whole.lines, "call {call}, pixel {pixels}");
    }
}

#[test]
fn lines_outside_the_picture_are_empty() {
    let mut buffer = SceneBuffer::<2, 1, 2>::new();
    let scene = buffer.prepare(&SCENE).unwrap();
    let mut renderer = Renderer::new(&scene, Size::new(8, 4));
    assert_eq!(renderer.line(3).count(), 8);
    assert_eq!(renderer.line(4).count(), 0);
    assert_eq!(renderer.line(u32::MAX).count(), 0);
    let mut line = [Rgb888::RED; 10];
    renderer.render_line(0, &mut line);
    assert_eq!(line[8..], [Rgb888::RED; 2]);
}

#[test]
fn observer_counts_every_ray() {
    #[derive(Default)]
    struct Reflected(u32);
    impl Observer for Reflected {
        fn ray(&mut self, kind: RayKind) {
            self.0 += u32::from(kind == RayKind::Reflected);
        }
    }

    let mut buffer = SceneBuffer::<2, 1, 2>::new();
    let mut scene = buffer.prepare(&SCENE).unwrap();
    let count = |scene: &_| {
        let mut renderer = Renderer::with_observer(scene, Size::new(16, 8), Stats::default());
        (0..8).for_each(|y| renderer.line(y).for_each(drop));
        *renderer.observer()
    };
    let stats = count(&scene);
    assert_eq!(stats.camera, 16 * 8);
    assert!(stats.reflected > 0 && stats.shadow > stats.camera / 2);
    assert_eq!(stats.transmitted, 0);

    // Within a line, the distance of the floor is computed once, so lines need fewer
    // intersection tests than single pixels.
    let mut renderer = Renderer::with_observer(&scene, Size::new(16, 8), Stats::default());
    for (x, y) in (0..8).flat_map(|y| (0..16).map(move |x| (x, y))) {
        renderer.pixel(x, y);
    }
    let single = *renderer.observer();
    let rays = |stats: Stats| u64::from(stats.camera + stats.reflected + stats.shadow);
    assert_eq!(rays(stats), rays(single));
    assert!((rays(single) / 2..2 * rays(single)).contains(&single.intersections));
    assert!(stats.intersections < single.intersections);

    let mut renderer = Renderer::with_observer(&scene, Size::new(16, 8), Reflected::default());
    (0..8).for_each(|y| renderer.line(y).for_each(drop));
    assert_eq!(renderer.observer().0, stats.reflected);

    scene.set_max_depth(0).unwrap();
    assert_eq!(count(&scene).reflected, 0);
}
