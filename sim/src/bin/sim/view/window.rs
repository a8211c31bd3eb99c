//! The window of `sim view`. It shows the picture and the status text, and receives key presses.

use std::time::{Duration, Instant};

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics_simulator::{MultiWindow, OutputSettings, SimulatorDisplay, SimulatorEvent};

use super::keys::Key;
use super::status;
use super::watch::Watch;
use super::workbench::Workbench;
use crate::args::View;
use crate::outcome::Outcome;

/// Smallest size of the window's area for the picture. A picture that is smaller than the area is
/// enlarged by an integer factor.
const MIN_AREA: Size = Size::new(640, 480);
/// Color of the window around the simulated display.
const SURROUND: Rgb888 = Rgb888::new(0x30, 0x32, 0x36);
/// Drawing time between two updates of the window.
const UPDATE_INTERVAL: Duration = Duration::from_millis(12);

/// Shows scenes in a window until the user closes it.
pub(crate) fn view(options: &View) -> Outcome {
    let mut workbench = Workbench::new(options)?;
    let mut watch = Watch::new(workbench.files())?;
    let mut window = Window::new(options.quality.size);
    let mut changed = true;
    let mut last = Instant::now();
    loop {
        if changed {
            window.draw(&mut workbench);
        }
        window.window.flush();
        changed = false;
        for key in window.window.events().filter_map(|event| key(&event)) {
            if key == Key::Quit {
                return Ok(());
            }
            workbench.press(key);
            changed = true;
        }
        if watch.has_changed() {
            workbench.reload();
            changed = true;
        }
        let start = Instant::now();
        workbench.advance(start - last);
        last = start;
        while start.elapsed() < UPDATE_INTERVAL && workbench.draw_step() {
            changed = true;
        }
    }
}

/// Returns the key that a window event stands for, or `None` if `sim view` ignores the event.
fn key(event: &SimulatorEvent) -> Option<Key> {
    match event {
        SimulatorEvent::Quit => Some(Key::Quit),
        SimulatorEvent::KeyDown {
            keycode, repeat, ..
        } => Key::named(&keycode.name()).filter(|key| !repeat || key.repeats()),
        _ => None,
    }
}

struct Window {
    window: MultiWindow,
    area: Size,
    status: SimulatorDisplay<Rgb888>,
}

impl Window {
    /// Opens a window that fits a picture of this size.
    fn new(size: Size) -> Self {
        let area = MIN_AREA.component_max(size);
        let below = Size::new(area.width, status::HEIGHT);
        let whole = Size::new(area.width, area.height + below.height);
        let mut window = MultiWindow::new("whitted", whole);
        let status = SimulatorDisplay::new(below);
        let corner = Point::new(0, area.height as i32);
        window.add_display(&status, corner, &OutputSettings::default());
        Self {
            window,
            area,
            status,
        }
    }

    /// Draws the picture and the status text.
    fn draw(&mut self, workbench: &mut Workbench) {
        let (panel, display) = workbench.picture();
        let fits = self.area.component_div(panel.size());
        let settings = display.settings(fits.width.min(fits.height).max(1));
        let margin = self.area - panel.output_size(&settings);
        let corner = Point::zero() + margin / 2;
        self.window.clear(SURROUND);
        self.window.add_display(panel, corner, &settings);
        self.window.update_display(panel);
        let Ok(()) = workbench.status().draw(&mut self.status);
        self.window.update_display(&self.status);
    }
}
