//! Rendering as a display gets it: step by step, in its pixels.

use std::time::Duration;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{OutputImage, OutputSettings};
use whitted::render::{AaSample, AntialiasedRenderer, RenderProgress as Steps, Step};
use whitted::{PreparedScene, Renderer};

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
    let blocks = passes.blocks().iter();
    let lines: u32 = blocks.map(|block| size.height.div_ceil(*block)).sum();
    let mut progress = Progress::new(lines);
    let (image, work) = frame(scene, size, shown, passes, &mut progress)?;
    let time = progress.finish();
    Ok(Drawing { image, work, time })
}

/// Draws on a display, as a part of more work.
pub(crate) fn frame(
    scene: &PreparedScene<'_>,
    size: Size,
    shown: Shown,
    passes: Passes,
    progress: &mut Progress,
) -> Outcome<(OutputImage<Rgb888>, Work)> {
    let mut panel = Panel::new(size, shown.format);
    let work = match passes.samples() {
        None => draw_passes(scene, shown, passes, &mut panel, progress)?,
        Some(samples) => {
            let (work, mut memory) = (Work::new(scene, size), two_lines(size));
            let mut renderer =
                AntialiasedRenderer::with_observer(scene, size, samples, &mut memory, work)?;
            renderer.set_output(shown.output());
            for y in 0..size.height {
                renderer.draw_line(y, &mut panel)?;
                progress.line();
            }
            renderer.observer().clone()
        }
    };
    // The default settings show the display's values as they are.
    let settings = OutputSettings::default();
    Ok((panel.display.to_rgb_output_image(&settings), work))
}

fn draw_passes(
    scene: &PreparedScene<'_>,
    shown: Shown,
    passes: Passes,
    panel: &mut Panel,
    progress: &mut Progress,
) -> Outcome<Work> {
    let mut renderer = Renderer::with_observer(scene, panel.size(), Work::new(scene, panel.size()));
    renderer.set_output(shown.output());
    let area = panel.bounding_box();
    let mut steps = match passes.order {
        Order::Scanlines => Steps::scanlines(area),
        Order::Progressive => Steps::progressive(area),
    };
    let finest = passes.blocks().last().copied().unwrap_or(1);
    while steps.block() >= finest {
        renderer.step(&mut steps, Step::Line, panel)?;
        progress.line();
    }
    Ok(renderer.observer().clone())
}

/// The memory that smooth edges take.
pub(crate) fn two_lines(size: Size) -> Vec<AaSample> {
    vec![AaSample::BLACK; 2 * size.width as usize]
}
