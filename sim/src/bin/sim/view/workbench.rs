use std::path::Path;
use std::time::Duration;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::SimulatorDisplay;
use whitted::{Camera, PreparedScene};
use whitted_sim::scene_file::Buffer;

use super::clock::Clock;
use super::cycle::Cycle;
use super::frame::Frame;
use super::keys::Key;
use super::options::Options;
use super::source::Source;
use super::status::{Notice, Status};
use super::viewpoint::Viewpoint;
use crate::args::{Order, Quality, View};
use crate::display::Display;
use crate::format::Format;
use crate::open;
use crate::outcome::Outcome;
use crate::output::{FileType, Output, write_png};

/// The state of `sim view`: scenes, options, camera and picture. The state does not need a window.
pub(super) struct Workbench {
    sources: Cycle<Source>,
    options: Options,
    viewpoint: Viewpoint,
    quality: Quality,
    /// Buffer for the prepared scene. The scene is decoded again for each drawing step.
    buffer: Box<Buffer>,
    clock: Clock,
    frame: Frame,
    message: String,
    shows_help: bool,
}

const GREETING: &str = "h: help";

impl Workbench {
    /// Loads the first scene and selects the display.
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
            clock: Clock::default(),
            message: GREETING.to_owned(),
            shows_help: false,
        };
        workbench.reload();
        Ok(workbench)
    }

    /// Returns the paths of the scene files.
    pub(super) fn files(&self) -> impl Iterator<Item = &Path> {
        self.sources
            .all()
            .iter()
            .map(|source| source.path.as_path())
    }

    /// Returns the picture drawn so far and its display.
    pub(super) fn picture(&mut self) -> (&SimulatorDisplay<Rgb888>, &Display) {
        self.frame.picture()
    }

    /// Carries out the action of a key.
    pub(super) fn press(&mut self, key: Key) {
        self.message = GREETING.to_owned();
        self.shows_help = key == Key::Help && !self.shows_help;
        match key {
            Key::Left => self.move_camera(|view| view.yaw -= Viewpoint::STEP),
            Key::Right => self.move_camera(|view| view.yaw += Viewpoint::STEP),
            Key::Up => self.move_camera(|view| view.pitch += Viewpoint::STEP),
            Key::Down => self.move_camera(|view| view.pitch -= Viewpoint::STEP),
            Key::Closer => self.move_camera(|view| view.zoom += 1),
            Key::Farther => self.move_camera(|view| view.zoom -= 1),
            Key::Reset => self.move_camera(|view| *view = Viewpoint::default()),
            Key::NextScene => self.switch_scene(Cycle::next),
            Key::PreviousScene => self.switch_scene(Cycle::previous),
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
            Key::Pause => self.clock.pause(),
            Key::Save => self.save(),
            Key::Help | Key::Quit => {}
        }
    }

    /// Reloads the scene from its file.
    pub(super) fn reload(&mut self) {
        self.sources.current_mut().read();
        self.restart();
    }

    /// Draws the next step of the picture. Returns false if the picture is complete.
    pub(super) fn draw_step(&mut self) -> bool {
        !self.frame.is_complete()
            && self.with_scene(|frame, scene, options| {
                frame.step(scene, options.output(scene.transfer()));
            })
    }

    /// Advances the time of an animation. If the current frame is complete, starts the next one.
    pub(super) fn advance(&mut self, passed: Duration) {
        self.clock.advance(passed);
        if self.frame.is_complete() && self.is_playing() && self.clock.next_frame() {
            self.restart();
        }
    }

    /// Returns true if the scene has an animation that is not over.
    fn is_playing(&mut self) -> bool {
        let Some(compiled) = self.sources.current().compiled() else {
            return false;
        };
        let animation = self.buffer.decode_animation(compiled);
        animation.is_ok_and(|animation| {
            let is_over = self.clock.frame() >= animation.duration();
            animation.is_animated() && (animation.is_looping() || !is_over)
        })
    }

    /// Returns the content of the status text.
    pub(super) fn status(&self) -> Status<'_> {
        let source = self.sources.current();
        Status {
            scene: source.name(),
            place: self.sources.position(),
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

    fn move_camera(&mut self, change: impl FnOnce(&mut Viewpoint)) {
        let (before, camera) = (self.viewpoint, self.camera());
        change(&mut self.viewpoint);
        match self.camera() {
            Some(moved) if Some(moved) != camera => {
                self.restart();
            }
            // The camera cannot move this far, so it stays where it was.
            _ => self.viewpoint = before,
        }
    }

    /// Returns the camera after the user's movements, or `None` if the scene cannot be prepared
    /// with it.
    fn camera(&mut self) -> Option<Camera> {
        let mut camera = None;
        self.with_scene(|_, scene, _| camera = Some(scene.camera()));
        camera
    }

    fn switch_scene(&mut self, select: impl FnOnce(&mut Cycle<Source>)) {
        select(&mut self.sources);
        self.viewpoint = Viewpoint::default();
        self.clock = Clock::default();
        self.clear();
        self.reload();
    }

    /// Restarts the drawing on a black display.
    fn clear(&mut self) {
        self.frame = Frame::new(*self.options.displays.current());
        self.restart();
    }

    /// Starts to draw the picture again. The old pixels stay until new pixels replace them. The
    /// frames of an animation are drawn line by line, because coarse blocks would flicker.
    fn restart(&mut self) -> bool {
        let order = match self.is_playing() {
            true => Order::Scanlines,
            false => *self.options.orders.current(),
        };
        self.with_scene(|frame, scene, options| {
            frame.restart(scene, order, *options.edges.current());
        })
    }

    /// Prepares the frame of the scene, and calls a function with the picture, this frame and the
    /// options. Returns false if the frame cannot be prepared, or if the scene's file was never
    /// valid.
    fn with_scene(&mut self, call: impl FnOnce(&mut Frame, &PreparedScene<'_>, &Options)) -> bool {
        let Some(compiled) = self.sources.current().compiled() else {
            return false;
        };
        let draw = || -> Outcome {
            let mut animation = self.buffer.decode_animation(compiled)?;
            let mut scene = animation.frame(self.clock.frame())?;
            open::apply_overrides(&mut scene, &self.quality)?;
            self.viewpoint.apply(&mut scene)?;
            call(&mut self.frame, &scene, &self.options);
            Ok(())
        };
        let drawn = draw();
        if let Err(error) = &drawn {
            self.message = error.to_string();
        }
        drawn.is_ok()
    }

    /// Saves the picture in the current directory, in the colors and shape of the display.
    fn save(&mut self) {
        let scene = self.sources.current().name();
        let (picture, display) = self.picture();
        let file = format!("{scene}-{}.png", display.name);
        let image = picture.to_rgb_output_image(&display.settings(1));
        let inputs: Vec<_> = self.files().map(Path::to_owned).collect();
        let output = Output::create(Path::new(&file), &FileType::PNG, &inputs);
        self.message = match output.and_then(|output| write_png(&image, output)) {
            Ok(()) => format!("wrote {file}"),
            Err(error) => error.to_string(),
        };
    }
}

/// Returns the scenes that the command line names. If it names none, returns all scenes in scenes/,
/// with `whitted` first.
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
