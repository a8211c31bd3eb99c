//! Rendering as a display gets it: line by line or in blocks, in its pixels.

use std::time::Duration;

use embedded_graphics::pixelcolor::{
    BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::{OutputImage, OutputSettings, SimulatorDisplay};
use whitted::{
    Antialiased, Drawing as Steps, Observer, PreparedScene, Renderer, Sample, Samples, Step,
};

use whitted_sim::cost::Work;

use crate::args::{Format, Order, Passes, Shown};
use crate::outcome::Outcome;
use crate::progress::{Progress, Watched};

/// A display's picture and what it took.
pub(crate) struct Drawing {
    pub(crate) image: OutputImage<Rgb888>,
    pub(crate) work: Work,
    pub(crate) time: Duration,
}

/// What of a picture is drawn, and what it looks like.
#[derive(Clone, Copy, Default)]
pub(crate) struct Look {
    pub(crate) shown: Shown,
    pub(crate) samples: Option<Samples>,
    pub(crate) passes: Passes,
}

/// Draws on a display.
pub(crate) fn draw(scene: &PreparedScene<'_>, size: Size, look: Look) -> Outcome<Drawing> {
    let mut progress = Progress::new(look.passes.rows(size.height));
    let (image, work) = frame(scene, size, look, &mut progress)?;
    let time = progress.finish();
    Ok(Drawing { image, work, time })
}

/// Draws on a display, as a part of more work.
pub(crate) fn frame(
    scene: &PreparedScene<'_>,
    size: Size,
    look: Look,
    progress: &mut Progress,
) -> Outcome<(OutputImage<Rgb888>, Work)> {
    let draw = match look.shown.format {
        Format::Rgb888 => on_display::<Rgb888>,
        Format::Rgb666 => on_display::<Rgb666>,
        Format::Rgb565 => on_display::<Rgb565>,
        Format::Rgb555 => on_display::<Rgb555>,
        Format::Gray8 => on_display::<Gray8>,
        Format::Gray4 => on_display::<Gray4>,
        Format::Gray2 => on_display::<Gray2>,
        Format::Binary => on_display::<BinaryColor>,
    };
    draw(scene, size, look, progress)
}

fn on_display<C>(
    scene: &PreparedScene<'_>,
    size: Size,
    look: Look,
    progress: &mut Progress,
) -> Outcome<(OutputImage<Rgb888>, Work)>
where
    C: PixelColor + whitted::Pixel + From<BinaryColor> + Into<Rgb888>,
{
    let mut display = SimulatorDisplay::<C>::new(size);
    let work = Work::new(scene);
    let work = match look.samples {
        None => {
            let mut renderer = Renderer::with_observer(scene, size, work);
            renderer.set_output(look.shown.output());
            in_steps(&mut renderer, look.passes, &mut display, progress)?;
            renderer.observer().clone()
        }
        Some(samples) => {
            let mut memory = two_lines(size);
            let mut renderer = Antialiased::with_observer(scene, size, samples, &mut memory, work)?;
            renderer.set_output(look.shown.output());
            let display = &mut display;
            renderer.draw(&mut Watched { display, progress })?;
            renderer.observer().clone()
        }
    };
    // The default settings show the display's values as they are.
    let image = display.to_rgb_output_image(&OutputSettings::default());
    Ok((image, work))
}

/// Draws some passes.
fn in_steps<D>(
    renderer: &mut Renderer<'_, impl Observer>,
    passes: Passes,
    display: &mut D,
    progress: &mut Progress,
) -> Result<(), D::Error>
where
    D: DrawTarget<Color: whitted::Pixel>,
{
    let area = Rectangle::new(Point::zero(), renderer.size());
    let mut steps = match passes.order {
        Order::Scanlines => Steps::scanlines(area),
        Order::Progressive => Steps::progressive(area),
    };
    let finest = passes.blocks().last().unwrap_or(1);
    while steps.block() >= finest {
        renderer.step(&mut steps, Step::Line, display)?;
        progress.line();
    }
    Ok(())
}

/// The memory that smooth edges take.
pub(crate) fn two_lines(size: Size) -> Vec<Sample> {
    vec![Sample::BLACK; 2 * size.width as usize]
}
