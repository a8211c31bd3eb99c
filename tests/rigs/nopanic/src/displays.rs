//! Every way to draw, for every color of a display.

use core::hint::black_box;

use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, IntoStorage, Rgb555, Rgb565,
    Rgb666, Rgb888,
};
use embedded_graphics_core::prelude::*;
use embedded_graphics_core::primitives::Rectangle;
use whitted::observer::Stats;
use whitted::render::{
    AaSample, AntialiasedRenderer, DirtyLines, RenderProgress, SampleCount, Step,
};
use whitted::{Color, PreparedScene, Renderer};

use crate::text;

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
    draw::<Rgb555>(scene);
    draw::<Rgb565>(scene);
    draw::<Rgb666>(scene);
    draw::<Rgb888>(scene);
    draw::<Bgr555>(scene);
    draw::<Bgr565>(scene);
    draw::<Bgr666>(scene);
    draw::<Bgr888>(scene);
    draw::<Gray8>(scene);
    draw::<Gray4>(scene);
    draw::<Gray2>(scene);
    draw::<BinaryColor>(scene);
    draw_otherwise(scene);

    let mut renderer = Renderer::with_observer(scene, size(), Stats::default());
    black_box(renderer.pixel(black_box(0), black_box(0)));
    black_box(renderer.line(black_box(0)).count());
    let mut line = [Color::<u16>::default(); 4];
    renderer.render_line(black_box(0), black_box(&mut line[..]));
    black_box((renderer.observer(), renderer.size()));
}

/// In a color that displays have.
fn draw<C>(scene: &PreparedScene<'_>)
where
    C: PixelColor + whitted::render::DisplayColor + IntoStorage<Storage: Into<u32>>,
{
    let mut display = Opaque::<C>(None);
    let mut renderer = Renderer::new(scene, size());
    renderer.set_output(black_box(renderer.output()));
    black_box(renderer.draw(&mut display).is_ok());
    black_box(renderer.draw_line(black_box(0), &mut display).is_ok());
    if let Some(color) = display.0 {
        send_changes(&[color; 4], &mut display);
    }
}

/// In ways whose code is no other for another color; that of all colors is
/// more than the flash of a real machine holds.
fn draw_otherwise(scene: &PreparedScene<'_>) {
    let mut display = Opaque::<Rgb565>(None);
    draw_in_steps(&mut Renderer::new(scene, size()), &mut display);

    let mut memory = [AaSample::BLACK; 8];
    let memory: &mut [AaSample] = black_box(&mut memory);
    match AntialiasedRenderer::new(scene, size(), black_box(SampleCount::Four), memory) {
        Ok(mut smooth) => {
            smooth.set_output(black_box(smooth.output()));
            black_box(smooth.line(black_box(0)).count());
            let mut line = [Color::<u16>::default(); 4];
            smooth.render_line(black_box(0), black_box(&mut line[..]));
            black_box((smooth.observer(), smooth.size()));
            black_box(smooth.draw(&mut display).is_ok());
            black_box(smooth.draw_line(black_box(0), &mut display).is_ok());
        }
        Err(error) => text::print(&error),
    }
}

fn draw_in_steps(renderer: &mut Renderer<'_>, display: &mut Opaque<Rgb565>) {
    let area = Rectangle::new(Point::new(black_box(0), black_box(0)), size());
    for drawing in [
        RenderProgress::scanlines(area),
        RenderProgress::progressive(area),
    ] {
        let mut drawing = black_box(drawing);
        while !drawing.is_complete() {
            let step = match drawing.block() {
                0 => Step::Pass,
                1 => Step::Line,
                _ => Step::Rays(black_box(0)),
            };
            black_box(
                renderer
                    .step(&mut drawing, black_box(step), display)
                    .is_ok(),
            );
        }
    }
}

fn send_changes<C>(line: &[C], display: &mut Opaque<C>)
where
    C: PixelColor + IntoStorage<Storage: Into<u32>>,
{
    let mut hashes = [0; 4];
    let count = DirtyLines::hashes(size());
    let hashes = hashes.get_mut(..count).unwrap_or_default();
    let mut changes = DirtyLines::new(black_box(0), hashes);
    black_box(
        changes
            .send_line(black_box(0), black_box(line), display)
            .is_ok(),
    );
    changes.forget();
}
