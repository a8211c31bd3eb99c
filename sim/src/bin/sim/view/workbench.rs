use std::path::Path;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::SimulatorDisplay;
use whitted::{Camera, PreparedScene};
use whitted_sim::scene_file::Buffer;

use super::cycle::Cycle;
use super::frame::Frame;
use super::keys::Key;
use super::options::Options;
use super::source::Source;
use super::status::{Notice, Status};
use super::viewpoint::Viewpoint;
use crate::args::{Format, Quality, View};
use crate::display::Display;
use crate::open;
use crate::outcome::Outcome;

/// What the window shows and what keys do, without a window.
pub(super) struct Workbench {
    sources: Cycle<Source>,
    options: Options,
    viewpoint: Viewpoint,
    quality: Quality,
    /// The memory that the scene is prepared in, for each step anew.
    buffer: Box<Buffer>,
    frame: Frame,
    message: String,
    shows_help: bool,
}

const GREETING: &str = "h: help";

impl Workbench {
    /// The first of the scenes on a display.
    pub(super) fn new(options: &View) -> Outcome<Self> {
        let sources = sources(options)?;
        let quality = options.quality;
        let plain = Display::plain(quality.size, Format::default());
        let options = Options::new(plain, options.display);
        let mut workbench = Self {
            frame: Frame::new(*options.displays.current()),
            sources,
            options,
            viewpoint: Viewpoint::default(),
            quality,
            buffer: Box::new(Buffer::new()),
            message: GREETING.to_owned(),
            shows_help: false,
        };
        workbench.read();
        Ok(workbench)
    }

    /// The files of the scenes.
    pub(super) fn files(&self) -> impl Iterator<Item = &Path> {
        self.sources
            .all()
            .iter()
            .map(|source| source.path.as_path())
    }

    /// What is on the display, and which display it is.
    pub(super) fn picture(&mut self) -> (&SimulatorDisplay<Rgb888>, &Display) {
        self.frame.picture()
    }

    /// Does what a key is for.
    pub(super) fn press(&mut self, key: Key) {
        self.message = GREETING.to_owned();
        self.shows_help = key == Key::Help && !self.shows_help;
        match key {
            Key::Left => self.look(|view| view.yaw -= Viewpoint::STEP),
            Key::Right => self.look(|view| view.yaw += Viewpoint::STEP),
            Key::Up => self.look(|view| view.pitch += Viewpoint::STEP),
            Key::Down => self.look(|view| view.pitch -= Viewpoint::STEP),
            Key::Closer => self.look(|view| view.zoom += 1),
            Key::Farther => self.look(|view| view.zoom -= 1),
            Key::Reset => self.look(|view| *view = Viewpoint::default()),
            Key::NextScene => self.turn_to(Cycle::next),
            Key::PreviousScene => self.turn_to(Cycle::previous),
            Key::Display => {
                self.options.displays.next();
                self.clear();
            }
            Key::Format => {
                self.options.next_format();
                self.clear();
            }
            Key::Order => {
                self.options.orders.next();
                self.clear();
            }
            Key::Dither => {
                self.options.dithers.next();
                self.restart();
            }
            Key::Transfer => {
                self.options.transfers.next();
                self.restart();
            }
            Key::Antialiasing => {
                self.options.edges.next();
                self.restart();
            }
            Key::Chip => self.options.boards.next(),
            Key::Save => self.save(),
            Key::Help | Key::Quit => {}
        }
    }

    /// Reads the scene anew, as its file has changed.
    pub(super) fn read(&mut self) {
        self.sources.current_mut().read(&mut self.buffer);
        self.restart();
    }

    /// Draws on for a while. Returns whether there was something to draw.
    pub(super) fn tick(&mut self) -> bool {
        let output = self.options.output();
        !self.frame.is_complete() && self.with_scene(|frame, scene| frame.step(scene, output))
    }

    /// What is said below the picture.
    pub(super) fn status(&self) -> Status<'_> {
        let source = self.sources.current();
        Status {
            scene: source.name(),
            place: self.sources.place(),
            options: self.options.text(),
            work: &self.frame.work,
            percent: self.frame.percent(),
            board: *self.options.boards.current(),
            memory: self.frame.memory,
            renderer: self.frame.renderer,
            notice: match source.error() {
                _ if self.shows_help => Notice::Help,
                Some(error) => Notice::Error(error),
                None => Notice::Message(&self.message),
            },
        }
    }

    fn look(&mut self, change: impl FnOnce(&mut Viewpoint)) {
        let (before, camera) = (self.viewpoint, self.camera());
        change(&mut self.viewpoint);
        match self.camera() {
            Some(moved) if Some(moved) != camera => {
                self.restart();
            }
            // It goes so far and no farther.
            _ => self.viewpoint = before,
        }
    }

    /// The camera where it was moved to, if it can be there.
    fn camera(&mut self) -> Option<Camera> {
        let mut camera = None;
        self.with_scene(|_, scene| camera = Some(scene.camera()));
        camera
    }

    fn turn_to(&mut self, scene: impl FnOnce(&mut Cycle<Source>)) {
        scene(&mut self.sources);
        self.viewpoint = Viewpoint::default();
        self.clear();
        self.read();
    }

    /// Begins anew on a dark display.
    fn clear(&mut self) {
        self.frame = Frame::new(*self.options.displays.current());
        self.restart();
    }

    /// Begins anew; what is shown stays until it is drawn over.
    fn restart(&mut self) -> bool {
        let order = *self.options.orders.current();
        let edges = *self.options.edges.current();
        self.with_scene(|frame, scene| frame.restart(scene, order, edges))
    }

    /// Does something with the scene as it is seen now. Returns whether it did,
    /// as a file may never have been fine.
    fn with_scene(&mut self, act: impl FnOnce(&mut Frame, &PreparedScene<'_>)) -> bool {
        let Some(scene) = self.sources.current().scene() else {
            return false;
        };
        let prepared = self
            .viewpoint
            .prepare(scene, &self.quality, &mut self.buffer);
        match &prepared {
            Ok(prepared) => act(&mut self.frame, prepared),
            Err(error) => self.message = error.to_string(),
        }
        prepared.is_ok()
    }

    /// Saves the picture in the current directory, as the display shows it.
    fn save(&mut self) {
        let scene = self.sources.current().name();
        let (picture, display) = self.picture();
        let file = format!("{scene}-{}.png", display.name);
        let image = picture.to_rgb_output_image(&display.settings(1));
        self.message = match image.save_png(&file) {
            Ok(()) => format!("wrote {file}"),
            Err(error) => format!("{file}: cannot be written: {error}"),
        };
    }
}

/// The scenes of the command line, or all, the project's first one first.
fn sources(options: &View) -> Outcome<Cycle<Source>> {
    let (first, others) = match options.scenes.split_first() {
        Some((first, others)) => (first.clone(), others.to_vec()),
        None => ("whitted".into(), open::all_scenes()?),
    };
    let first = Source::find(&first)?;
    let others: Outcome<Vec<_>> = others.iter().map(|path| Source::find(path)).collect();
    let others = others?.into_iter().filter(|other| other.path != first.path);
    let others: Vec<_> = others.collect();
    Ok(Cycle::new(first, others))
}

#[cfg(test)]
mod tests;
