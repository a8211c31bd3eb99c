//! Calls every drawing function, for every color type of embedded-graphics.

use core::cell::RefCell;
use core::hint::black_box;
use core::ops::ControlFlow;

use embedded_graphics_core::pixelcolor::{
    Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, IntoStorage, Rgb555, Rgb565,
    Rgb666, Rgb888,
};
use embedded_graphics_core::prelude::*;
use embedded_graphics_core::primitives::Rectangle;
use whitted::observer::{Observer, Poller, Stats};
use whitted::render::{
    AaSample, AntialiasedRenderer, DirtyLines, Picture, RenderProgress, SampleCount, Step,
};
use whitted::{Color, PreparedScene, Renderer};

use crate::text;

/// Display with operations that may succeed or fail. The compiler cannot know the result.
struct UnknownDisplay<C>(Option<C>);

/// Error of [`UnknownDisplay`].
struct DisplayError;

impl<C> OriginDimensions for UnknownDisplay<C> {
    fn size(&self) -> Size {
        size()
    }
}

impl<C: PixelColor> DrawTarget for UnknownDisplay<C> {
    type Color = C;
    type Error = DisplayError;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), DisplayError>
    where
        I: IntoIterator<Item = Pixel<C>>,
    {
        for Pixel(_, color) in pixels {
            self.0 = black_box(Some(color));
            if black_box(false) {
                return Err(DisplayError);
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), DisplayError>
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
    draw_rgb565(scene);

    let mut renderer = Renderer::with_observer(scene, size(), Stats::default());
    black_box(renderer.pixel(black_box(0), black_box(0)));
    black_box(renderer.line(black_box(0)).count());
    let mut line = [Color::<u16>::default(); 4];
    renderer.render_line(black_box(0), black_box(&mut line[..]));
    black_box((renderer.observer(), renderer.size()));
}

/// Calls the drawing functions with the color type `C`.
fn draw<C>(scene: &PreparedScene<'_>)
where
    C: PixelColor + whitted::render::DisplayColor + IntoStorage<Storage: Into<u32>>,
{
    let mut display = UnknownDisplay::<C>(None);
    let mut renderer = Renderer::new(scene, size());
    renderer.set_output(black_box(renderer.output()));
    black_box(renderer.draw(&mut display).is_ok());
    black_box(renderer.draw_line(black_box(0), &mut display).is_ok());
    if let Some(color) = display.0 {
        send_dirty_lines(&[color; 4], &mut display);
    }
}

/// Calls the functions whose code hardly depends on the color type. The color type is
/// `Rgb565`.
///
/// Calling these functions with all color types would exceed the flash of the machine.
fn draw_rgb565(scene: &PreparedScene<'_>) {
    let mut display = UnknownDisplay::<Rgb565>(None);
    let poller = Poller::new(black_box(0), || match black_box(false) {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    });
    let mut renderer = Renderer::with_observer(scene, size(), poller);
    draw_in_steps(&mut renderer, &mut display);
    if black_box(renderer.observer().is_interrupted()) {
        renderer.observer_mut().resume();
    }

    draw_pictures(scene, &mut display);

    let mut memory = [AaSample::BLACK; 8];
    let memory: &mut [AaSample] = black_box(&mut memory);
    match AntialiasedRenderer::new(scene, size(), black_box(SampleCount::Four), memory) {
        Ok(mut renderer) => {
            renderer.set_output(black_box(renderer.output()));
            black_box(renderer.line(black_box(0)).count());
            let mut line = [Color::<u16>::default(); 4];
            renderer.render_line(black_box(0), black_box(&mut line[..]));
            black_box((renderer.observer(), renderer.size()));
            black_box(renderer.draw(&mut display).is_ok());
            black_box(renderer.draw_line(black_box(0), &mut display).is_ok());
        }
        Err(error) => text::print(&error),
    }
}

/// Draws an opaque and a transparent picture, with and without smooth edges.
fn draw_pictures(scene: &PreparedScene<'_>, display: &mut UnknownDisplay<Rgb565>) {
    let position = Point::new(black_box(0), black_box(0));
    let picture = Picture::new(scene, position, size()).with_output(black_box(Default::default()));
    let transparent = picture.transparent();
    let mut progress = black_box(RenderProgress::scanlines(picture.bounding_box()));
    black_box(
        transparent
            .step(&mut progress, black_box(Step::Line), display)
            .is_ok(),
    );
    black_box(picture.draw(display).is_ok());
    black_box(transparent.draw(display).is_ok());

    let memory = RefCell::new([AaSample::BLACK; 8]);
    let four = black_box(SampleCount::Four);
    if let Ok(picture) = transparent.antialiased(four, &memory) {
        black_box((picture.draw(display).is_ok(), picture.bounding_box()));
    }
}

fn draw_in_steps(renderer: &mut Renderer<'_, impl Observer>, display: &mut UnknownDisplay<Rgb565>) {
    let area = Rectangle::new(Point::new(black_box(0), black_box(0)), size());
    for progress in [
        RenderProgress::scanlines(area),
        RenderProgress::progressive(area),
    ] {
        let mut progress = black_box(progress);
        while !progress.is_complete() {
            let step = match progress.block() {
                0 => Step::Pass,
                1 => Step::Line,
                _ => Step::Rays(black_box(0)),
            };
            black_box(
                renderer
                    .step(&mut progress, black_box(step), display)
                    .is_ok(),
            );
        }
    }
}

fn send_dirty_lines<C>(line: &[C], display: &mut UnknownDisplay<C>)
where
    C: PixelColor + IntoStorage<Storage: Into<u32>>,
{
    let mut hashes = [0; 4];
    let count = DirtyLines::hashes(size());
    let hashes = hashes.get_mut(..count).unwrap_or_default();
    let mut dirty_lines = DirtyLines::new(black_box(0), hashes);
    black_box(
        dirty_lines
            .send_line(black_box(0), black_box(line), display)
            .is_ok(),
    );
    dirty_lines.forget();
}
