//! Renders scenes to a simulated display.

use std::time::Duration;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{OutputImage, OutputSettings};
use whitted::render::{AaSample, AntialiasedRenderer, RenderProgress, Step};
use whitted::{PreparedScene, Renderer};

use whitted_sim::cost::Work;

use crate::args::{DisplayOptions, Order, Passes};
use crate::outcome::Outcome;
use crate::panel::Panel;
use crate::progress::Progress;

/// A picture on a display, the work that was counted while it was rendered, and the rendering time.
pub(crate) struct Drawing {
    pub(crate) image: OutputImage<Rgb888>,
    pub(crate) work: Work,
    pub(crate) time: Duration,
}

/// Draws a scene on a display.
pub(crate) fn draw(
    scene: &PreparedScene<'_>,
    size: Size,
    options: DisplayOptions,
    passes: Passes,
) -> Outcome<Drawing> {
    let blocks = passes.blocks().iter();
    let lines: u32 = blocks.map(|block| size.height.div_ceil(*block)).sum();
    let mut progress = Progress::new(lines);
    let (image, work) = draw_frame(scene, size, options, passes, &mut progress)?;
    let time = progress.finish();
    Ok(Drawing { image, work, time })
}

/// Draws a scene on a display, and advances a progress bar. An animation uses one progress bar for
/// all frames.
pub(crate) fn draw_frame(
    scene: &PreparedScene<'_>,
    size: Size,
    options: DisplayOptions,
    passes: Passes,
    progress: &mut Progress,
) -> Outcome<(OutputImage<Rgb888>, Work)> {
    let mut panel = Panel::new(size, options.format);
    let work = match passes.samples() {
        None => draw_passes(scene, options, passes, &mut panel, progress)?,
        Some(samples) => {
            let (work, mut memory) = (Work::new(scene, size), two_lines(size));
            let mut renderer =
                AntialiasedRenderer::with_observer(scene, size, samples, &mut memory, work)?;
            renderer.set_output(options.output());
            for y in 0..size.height {
                renderer.draw_line(y, &mut panel)?;
                progress.line();
            }
            renderer.observer().clone()
        }
    };
    // With the default settings, the simulator does not change the pixels of the display.
    let settings = OutputSettings::default();
    Ok((panel.display.to_rgb_output_image(&settings), work))
}

fn draw_passes(
    scene: &PreparedScene<'_>,
    options: DisplayOptions,
    passes: Passes,
    panel: &mut Panel,
    progress: &mut Progress,
) -> Outcome<Work> {
    let mut renderer = Renderer::with_observer(scene, panel.size(), Work::new(scene, panel.size()));
    renderer.set_output(options.output());
    let area = panel.bounding_box();
    let mut steps = match passes.order {
        Order::Scanlines => RenderProgress::scanlines(area),
        Order::Progressive => RenderProgress::progressive(area),
    };
    let finest = passes.blocks().last().copied().unwrap_or(1);
    while steps.block() >= finest {
        renderer.step(&mut steps, Step::Line, panel)?;
        progress.line();
    }
    Ok(renderer.observer().clone())
}

/// Allocates the two lines of samples that the antialiasing renderer needs.
pub(crate) fn two_lines(size: Size) -> Vec<AaSample> {
    vec![AaSample::BLACK; 2 * size.width as usize]
}
