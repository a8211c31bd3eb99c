//! Renders scenes to a simulated display.

use std::time::Duration;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{OutputImage, SimulatorDisplay};
use whitted::render::{
    AaSample, AntialiasedRenderer, Dither, Output, RenderProgress, Step, Transfer,
};
use whitted::{PreparedScene, Renderer};

use whitted_sim::cost::Work;

use crate::args::{DisplayOptions, Order, Passes};
use crate::display::Display;
use crate::estimate;
use crate::outcome::Outcome;
use crate::panel::Panel;
use crate::progress::Progress;

/// A picture on a display, the work that was counted while it was rendered, and the rendering time.
pub(crate) struct Drawing {
    pub(crate) image: OutputImage<Rgb888>,
    /// Transfer function with which the picture is encoded.
    pub(crate) transfer: Transfer,
    pub(crate) work: Work,
    pub(crate) time: Duration,
}

/// Settings of a picture.
#[derive(Clone, Copy)]
pub(crate) struct Settings {
    pub(crate) display: Display,
    /// Transfer function, or `None` for that of the scene.
    pub(crate) transfer: Option<Transfer>,
    pub(crate) dither: Dither,
    pub(crate) passes: Passes,
}

impl Settings {
    /// Combines options of the command line. The picture has the given size unless the user names a
    /// display.
    pub(crate) fn new(size: Size, options: DisplayOptions, passes: impl Into<Passes>) -> Self {
        Self {
            display: options.display(size),
            transfer: options.transfer(),
            dither: options.dither(),
            passes: passes.into(),
        }
    }

    /// Returns the conversion of the scene's colors to display colors.
    pub(crate) fn output(&self, scene: &PreparedScene<'_>) -> Output {
        Output {
            transfer: self.transfer.unwrap_or(scene.transfer()),
            dither: self.dither,
        }
    }
}

/// Draws a scene on a display. Each display pixel becomes a square of `scale` by `scale` pixels.
pub(crate) fn draw(scene: &PreparedScene<'_>, settings: &Settings, scale: u32) -> Outcome<Drawing> {
    let Settings {
        display, passes, ..
    } = settings;
    let blocks = passes.blocks().iter();
    let lines: u32 = blocks
        .map(|block| display.size.height.div_ceil(*block))
        .sum();
    estimate::announce(scene, display.size, 1);
    let mut progress = Progress::new(lines);
    let (picture, work) = draw_frame(scene, settings, &mut progress)?;
    let time = progress.finish();
    Ok(Drawing {
        image: display.appearance(picture, scale),
        transfer: settings.output(scene).transfer,
        work,
        time,
    })
}

/// Draws a scene on a display, and advances a progress bar. An animation uses one progress bar for
/// all frames.
pub(crate) fn draw_frame(
    scene: &PreparedScene<'_>,
    settings: &Settings,
    progress: &mut Progress,
) -> Outcome<(SimulatorDisplay<Rgb888>, Work)> {
    let Settings {
        display, passes, ..
    } = *settings;
    let output = settings.output(scene);
    let size = display.size;
    let mut panel = Panel::new(size, display.format);
    let work = match passes.edges.samples() {
        None => draw_passes(scene, output, passes, &mut panel, progress)?,
        Some(samples) => {
            let (work, mut memory) = (Work::new(scene, size), two_lines(size));
            let mut renderer =
                AntialiasedRenderer::with_observer(scene, size, samples, &mut memory, work)?;
            renderer.set_output(output);
            for y in 0..size.height {
                renderer.draw_line(y, &mut panel)?;
                progress.line();
            }
            renderer.observer().clone()
        }
    };
    Ok((panel.display, work))
}

fn draw_passes(
    scene: &PreparedScene<'_>,
    output: Output,
    passes: Passes,
    panel: &mut Panel,
    progress: &mut Progress,
) -> Outcome<Work> {
    let mut renderer = Renderer::with_observer(scene, panel.size(), Work::new(scene, panel.size()));
    renderer.set_output(output);
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
