use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::SimulatorDisplay;
use whitted::render::{AntialiasedRenderer, Output, RenderProgress, SampleCount, Step};
use whitted::{PreparedScene, Renderer};
use whitted_sim::cost::Work;

use crate::args::Order;
use crate::display::Display;
use crate::draw::two_lines;
use crate::memory::memory;
use crate::panel::Panel;

/// Rays per drawing step. A step takes a few milliseconds.
const STEP: Step = Step::Rays(2000);

/// A picture that is drawn in short steps, so that the window can react to keys between two steps.
pub(super) struct Frame {
    panel: Panel,
    display: Display,
    drawing: RenderProgress,
    /// Number of additional rays at edges. The picture is first drawn without antialiasing, and
    /// then redrawn with it. `None` if the picture is not to be redrawn.
    edges: Option<SampleCount>,
    /// Work done so far.
    pub(super) work: Work,
    /// Size of the prepared scene in bytes.
    pub(super) memory: usize,
    /// Size of the renderer and its line buffers in bytes.
    pub(super) renderer: usize,
}

impl Frame {
    /// Creates a black display.
    pub(super) fn new(display: Display) -> Self {
        let panel = Panel::new(display.size, display.format);
        Self {
            drawing: RenderProgress::scanlines(panel.bounding_box()),
            panel,
            display,
            edges: None,
            work: Work::default(),
            memory: 0,
            renderer: 0,
        }
    }

    /// Starts to draw the picture again. The old pixels stay until new pixels replace them.
    pub(super) fn restart(
        &mut self,
        scene: &PreparedScene<'_>,
        order: Order,
        edges: Option<SampleCount>,
    ) {
        let area = self.panel.bounding_box();
        self.drawing = match order {
            Order::Progressive => RenderProgress::progressive(area),
            Order::Scanlines => RenderProgress::scanlines(area),
        };
        self.edges = edges;
        self.work = Work::new(scene, self.panel.size());
        self.memory = memory(scene.counts());
        self.renderer = match edges {
            None => size_of::<Renderer<'_>>(),
            Some(_) => {
                size_of::<AntialiasedRenderer<'_, '_>>()
                    + size_of_val(&*two_lines(self.panel.size()))
            }
        };
    }

    /// Draws the next step of the picture.
    pub(super) fn step(&mut self, scene: &PreparedScene<'_>, output: Output) {
        if self.drawing.is_complete() {
            return self.smooth(scene, output);
        }
        let work = self.work.clone();
        let mut renderer = Renderer::with_observer(scene, self.panel.size(), work);
        renderer.set_output(output);
        let Ok(()) = renderer.step(&mut self.drawing, STEP, &mut self.panel);
        self.work = renderer.observer().clone();
    }

    /// If antialiasing is selected, redraws the whole picture with antialiasing. The call takes a
    /// few tenths of a second, because it cannot be divided into steps.
    fn smooth(&mut self, scene: &PreparedScene<'_>, output: Output) {
        let Some(samples) = self.edges.take() else {
            return;
        };
        let (size, work) = (self.panel.size(), Work::new(scene, self.panel.size()));
        let mut lines = two_lines(size);
        let smooth = AntialiasedRenderer::with_observer(scene, size, samples, &mut lines, work);
        // If the picture is too large for the antialiasing renderer, it stays as it is.
        if let Ok(mut smooth) = smooth {
            smooth.set_output(output);
            let Ok(()) = smooth.draw(&mut self.panel);
            self.work = smooth.observer().clone();
        }
    }

    /// Returns the picture drawn so far and its display.
    pub(super) fn picture(&mut self) -> (&SimulatorDisplay<Rgb888>, &Display) {
        self.display.cut(&mut self.panel.display);
        (&self.panel.display, &self.display)
    }

    /// Returns true if the picture is complete.
    pub(super) fn is_complete(&self) -> bool {
        self.drawing.is_complete() && self.edges.is_none()
    }

    /// Returns how much of the picture is traced, in percent of its pixels.
    pub(super) fn percent(&self) -> u64 {
        let Size { width, height } = self.panel.size();
        let pixels = u64::from(width) * u64::from(height);
        // With antialiasing, a pixel can have several camera rays. The result is therefore limited
        // to 100 %.
        (u64::from(self.work.stats.camera) * 100 / pixels).min(100)
    }
}
