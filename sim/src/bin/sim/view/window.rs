//! The window: pictures out, keys in.

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

/// What pictures have room in: they are scaled up to it, by whole numbers.
const ROOM: Size = Size::new(640, 480);
/// Around the display.
const TABLE: Rgb888 = Rgb888::new(0x30, 0x32, 0x36);
/// How long is drawn before the window is looked after again.
const PATIENCE: Duration = Duration::from_millis(12);

/// Shows scenes until the window is closed.
pub(crate) fn view(options: &View) -> Outcome {
    let mut workbench = Workbench::new(options)?;
    let mut watch = Watch::new(workbench.files())?;
    let mut window = Window::new(options.quality.size);
    let mut changed = true;
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
            workbench.read();
            changed = true;
        }
        let start = Instant::now();
        while start.elapsed() < PATIENCE && workbench.tick() {
            changed = true;
        }
    }
}

/// The key that is meant, if it is one.
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
    room: Size,
    status: SimulatorDisplay<Rgb888>,
}

impl Window {
    /// A window with room for a picture of the size.
    fn new(size: Size) -> Self {
        let room = ROOM.component_max(size);
        let below = Size::new(room.width, status::HEIGHT);
        let whole = Size::new(room.width, room.height + below.height);
        let mut window = MultiWindow::new("whitted", whole);
        let status = SimulatorDisplay::new(below);
        let corner = Point::new(0, room.height as i32);
        window.add_display(&status, corner, &OutputSettings::default());
        Self {
            window,
            room,
            status,
        }
    }

    /// Draws how things are.
    fn draw(&mut self, workbench: &mut Workbench) {
        let (panel, display) = workbench.picture();
        let fits = self.room.component_div(panel.size());
        let settings = display.settings(fits.width.min(fits.height).max(1));
        let margin = self.room - panel.output_size(&settings);
        let corner = Point::zero() + margin / 2;
        self.window.clear(TABLE);
        self.window.add_display(panel, corner, &settings);
        self.window.update_display(panel);
        let Ok(()) = workbench.status().draw(&mut self.status);
        self.window.update_display(&self.status);
    }
}
