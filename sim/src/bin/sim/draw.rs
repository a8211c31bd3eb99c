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

/// Draws on a display.
pub(crate) fn draw(
    scene: &PreparedScene<'_>,
    size: Size,
    shown: Shown,
    samples: Option<Samples>,
) -> Outcome<Drawing> {
    let draw = match shown.format {
        Format::Rgb888 => on_display::<Rgb888>,
        Format::Rgb666 => on_display::<Rgb666>,
        Format::Rgb565 => on_display::<Rgb565>,
        Format::Rgb555 => on_display::<Rgb555>,
        Format::Gray8 => on_display::<Gray8>,
        Format::Gray4 => on_display::<Gray4>,
        Format::Gray2 => on_display::<Gray2>,
        Format::Binary => on_display::<BinaryColor>,
    };
    draw(scene, size, shown, samples)
}

fn on_display<C>(
    scene: &PreparedScene<'_>,
    size: Size,
    shown: Shown,
    samples: Option<Samples>,
) -> Outcome<Drawing>
where
    C: PixelColor + whitted::Pixel + From<BinaryColor> + Into<Rgb888>,
{
    let mut display = SimulatorDisplay::<C>::new(size);
    let work = Work::new(scene);
    let (work, time) = match samples {
        None => {
            let mut renderer = Renderer::with_observer(scene, size, work);
            renderer.set_output(shown.output());
            let time = in_steps(&mut renderer, shown.passes, &mut display)?;
            (renderer.observer().clone(), time)
        }
        Some(samples) => {
            let mut memory = two_lines(size);
            let mut renderer = Antialiased::with_observer(scene, size, samples, &mut memory, work)?;
            renderer.set_output(shown.output());
            let mut watched = Watched {
                display: &mut display,
                progress: Progress::new(size.height),
            };
            renderer.draw(&mut watched)?;
            let time = watched.progress.finish();
            (renderer.observer().clone(), time)
        }
    };
    // The default settings show the display's values as they are.
    let image = display.to_rgb_output_image(&OutputSettings::default());
    Ok(Drawing { image, work, time })
}

/// Draws some passes, and tells how long that took.
fn in_steps<D>(
    renderer: &mut Renderer<'_, impl Observer>,
    passes: Passes,
    display: &mut D,
) -> Result<Duration, D::Error>
where
    D: DrawTarget<Color: whitted::Pixel>,
{
    let size = renderer.size();
    let area = Rectangle::new(Point::zero(), size);
    let (mut steps, blocks): (_, &[u32]) = match passes.order {
        Order::Scanlines => (Steps::scanlines(area), &[1]),
        Order::Progressive => (Steps::progressive(area), &[16, 8, 4, 2, 1]),
    };
    let blocks = blocks.iter().take(passes.most.into());
    let finest = blocks.clone().min().copied().unwrap_or(1);
    let mut progress = Progress::new(blocks.map(|block| size.height.div_ceil(*block)).sum());
    while steps.block() >= finest {
        renderer.step(&mut steps, Step::Line, display)?;
        progress.line();
    }
    Ok(progress.finish())
}

/// The memory that smooth edges take.
pub(crate) fn two_lines(size: Size) -> Vec<Sample> {
    vec![Sample::BLACK; 2 * size.width as usize]
}
