use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::OutputImage;
use whitted::animation::PreparedAnimation;
use whitted::{PreparedScene, Real};

use super::schedule::Schedule;
use crate::args::Quality;
use crate::display::Display;
use crate::draw::{Settings, draw_frame};
use crate::estimate;
use crate::open::{Scene, apply_overrides};
use crate::outcome::Outcome;
use crate::progress::Progress;

/// Renders the frames of an animation one by one, so that only one frame is in memory.
pub(super) struct Frames<'a> {
    animation: Animation<'a>,
    pub(super) schedule: &'a Schedule,
    settings: Settings,
    progress: Progress,
}

impl<'a> Frames<'a> {
    /// Starts an animation, and announces it if it takes minutes.
    pub(super) fn new(
        scene: &'a Scene,
        animation: PreparedAnimation<'a>,
        quality: Quality,
        settings: Settings,
        schedule: &'a Schedule,
    ) -> Outcome<Self> {
        let mut animation = Animation {
            scene,
            animation,
            quality,
        };
        let (size, count) = (settings.display.size, schedule.times.len());
        let first = animation.prepare(schedule.times.first().copied().unwrap_or_default())?;
        estimate::announce(&first, size, count);
        Ok(Self {
            animation,
            schedule,
            settings,
            progress: Progress::new(count as u64 * u64::from(size.height)),
        })
    }

    /// Returns the number of frames.
    pub(super) fn count(&self) -> usize {
        self.schedule.times.len()
    }

    /// Returns the size of the frames.
    pub(super) fn size(&self) -> Size {
        self.settings.display.size
    }

    /// Returns true if the user did not turn dithering off.
    pub(super) fn is_dithered(&self) -> bool {
        self.settings.dither == whitted::render::Dither::Ordered
    }

    /// Renders the frame with an index.
    pub(super) fn draw(&mut self, index: usize) -> Outcome<OutputImage<Rgb888>> {
        self.draw_on(index, self.settings.display)
    }

    /// Renders the frame with an index in another size.
    pub(super) fn sample(&mut self, index: usize, size: Size) -> Outcome<OutputImage<Rgb888>> {
        self.progress.add_lines(size.height);
        self.draw_on(index, self.settings.display.resized(size))
    }

    fn draw_on(&mut self, index: usize, display: Display) -> Outcome<OutputImage<Rgb888>> {
        let time = self.schedule.times.get(index).copied().unwrap_or_default();
        let prepared = self.animation.prepare(time)?;
        let settings = Settings {
            display,
            ..self.settings
        };
        let (picture, _) = draw_frame(&prepared, &settings, &mut self.progress)?;
        Ok(display.appearance(picture, 1))
    }
}

/// An animated scene, and limits of the ray tree from the command line.
struct Animation<'a> {
    scene: &'a Scene,
    animation: PreparedAnimation<'a>,
    quality: Quality,
}

impl Animation<'_> {
    /// Prepares the scene at a time in seconds.
    fn prepare(&mut self, time: Real) -> Outcome<PreparedScene<'_>> {
        let prepared = self.animation.frame(time);
        let mut prepared = prepared.map_err(|error| self.scene.explain_frame(error, time))?;
        apply_overrides(&mut prepared, &self.quality)?;
        Ok(prepared)
    }
}
