//! Rendering as a display gets it: step by step, in its pixels.

use std::time::Duration;

use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::{OutputImage, OutputSettings, SimulatorDisplay};
use whitted::{Drawing as Steps, PreparedScene, Renderer, Step};

use whitted_sim::cost::Work;

use crate::args::{Format, Order, Passes};
use crate::outcome::Outcome;
use crate::progress::Progress;

/// A display's picture and what it took.
pub(crate) struct Drawing {
    pub(crate) image: OutputImage<Rgb888>,
    pub(crate) work: Work,
    pub(crate) time: Duration,
}

/// Draws on a display of the format.
pub(crate) fn draw(
    scene: &PreparedScene<'_>,
    size: Size,
    format: Format,
    passes: Passes,
) -> Outcome<Drawing> {
    match format {
        Format::Rgb888 => on_display::<Rgb888>(scene, size, passes),
        Format::Rgb565 => on_display::<Rgb565>(scene, size, passes),
        Format::Gray8 => on_display::<Gray8>(scene, size, passes),
        Format::Gray4 => on_display::<Gray4>(scene, size, passes),
        Format::Gray2 => on_display::<Gray2>(scene, size, passes),
        Format::Bw => on_display::<BinaryColor>(scene, size, passes),
    }
}

fn on_display<C>(scene: &PreparedScene<'_>, size: Size, passes: Passes) -> Outcome<Drawing>
where
    C: PixelColor + whitted::Pixel + From<BinaryColor> + Into<Rgb888>,
{
    let mut display = SimulatorDisplay::<C>::new(size);
    let mut renderer = Renderer::with_observer(scene, size, Work::new(scene));
    let area = Rectangle::new(Point::zero(), size);
    let (mut steps, blocks): (_, &[u32]) = match passes.order {
        Order::Scanlines => (Steps::scanlines(area), &[1]),
        Order::Progressive => (Steps::progressive(area), &[16, 8, 4, 2, 1]),
    };
    let blocks = blocks.iter().take(passes.most.into());
    let finest = blocks.clone().min().copied().unwrap_or(1);
    let mut progress = Progress::new(blocks.map(|block| size.height.div_ceil(*block)).sum());
    while steps.block() >= finest {
        renderer.step(&mut steps, Step::Line, &mut display)?;
        progress.line();
    }
    let time = progress.finish();
    // The default settings show the display's values as they are.
    let image = display.to_rgb_output_image(&OutputSettings::default());
    Ok(Drawing {
        image,
        work: renderer.observer().clone(),
        time,
    })
}
