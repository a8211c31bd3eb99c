//! Every way to draw, for every color of a display.

use core::hint::black_box;

use embedded_graphics_core::pixelcolor::{
    Bgr565, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb666, Rgb888,
};
use embedded_graphics_core::prelude::*;
use embedded_graphics_core::primitives::Rectangle;
use whitted::{Color, PreparedScene, Renderer, Stats};

/// A display that takes pixels, or fails.
struct Opaque<C>(Option<C>);

/// What a display fails with.
struct Unplugged;

impl<C> OriginDimensions for Opaque<C> {
    fn size(&self) -> Size {
        size()
    }
}

impl<C: PixelColor> DrawTarget for Opaque<C> {
    type Color = C;
    type Error = Unplugged;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Unplugged>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        for Pixel(_, color) in pixels {
            self.0 = black_box(Some(color));
            if black_box(false) {
                return Err(Unplugged);
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Unplugged>
    where
        I: IntoIterator<Item = C>,
    {
        self.draw_iter(
            area.points()
                .zip(colors)
                .map(|(at, color)| Pixel(at, color)),
        )
    }
}

fn size() -> Size {
    Size::new(black_box(0), black_box(0))
}

pub(crate) fn draw_on_all(scene: &PreparedScene<'_>) {
    draw::<Rgb565>(scene);
    draw::<Rgb666>(scene);
    draw::<Rgb888>(scene);
    draw::<Bgr565>(scene);
    draw::<Bgr888>(scene);
    draw::<Gray8>(scene);
    draw::<Gray4>(scene);
    draw::<Gray2>(scene);
    draw::<BinaryColor>(scene);

    let mut renderer = Renderer::with_observer(scene, size(), Stats::default());
    black_box(renderer.pixel(black_box(0), black_box(0)));
    black_box(renderer.line(black_box(0)).count());
    let mut line = [Color::<u16>::default(); 4];
    renderer.render_line(black_box(0), black_box(&mut line[..]));
    black_box((renderer.observer(), renderer.size()));
}

fn draw<C: PixelColor + whitted::Pixel>(scene: &PreparedScene<'_>) {
    let mut display = Opaque::<C>(None);
    let mut renderer = Renderer::new(scene, size());
    black_box(renderer.draw(&mut display).is_ok());
    black_box(renderer.draw_line(black_box(0), &mut display).is_ok());
}
