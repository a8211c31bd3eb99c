//! Rendering as a display gets it: step by step, in its pixels.

use std::time::Duration;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::{OutputImage, OutputSettings};
use whitted::{Drawing as Steps, PreparedScene, Renderer, Step};

use whitted_sim::cost::Work;

use crate::args::{Order, Passes, Shown};
use crate::outcome::Outcome;
use crate::panel::Panel;
use crate::progress::Progress;

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
    passes: Passes,
) -> Outcome<Drawing> {
    let mut panel = Panel::new(size, shown.format);
    let mut renderer = Renderer::with_observer(scene, size, Work::new(scene));
    renderer.set_output(shown.output());
    let area = Rectangle::new(Point::zero(), size);
    let (mut steps, blocks): (_, &[u32]) = match passes.order {
        Order::Scanlines => (Steps::scanlines(area), &[1]),
        Order::Progressive => (Steps::progressive(area), &[16, 8, 4, 2, 1]),
    };
    let blocks = blocks.iter().take(passes.most.into());
    let finest = blocks.clone().min().copied().unwrap_or(1);
    let mut progress = Progress::new(blocks.map(|block| size.height.div_ceil(*block)).sum());
    while steps.block() >= finest {
        renderer.step(&mut steps, Step::Line, &mut panel)?;
        progress.line();
    }
    let time = progress.finish();
    // The default settings show the display's values as they are.
    let image = panel
        .display
        .to_rgb_output_image(&OutputSettings::default());
    Ok(Drawing {
        image,
        work: renderer.observer().clone(),
        time,
    })
}
