//! Status text below the picture in `sim view`.

use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::iso_8859_1::FONT_6X13;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Baseline, Text};
use whitted::observer::Stats;
use whitted_sim::cost::{Board, Work};

use super::keys::HELP;
use crate::number::{duration, grouped};

const LINES: usize = 6;
const LINE_HEIGHT: u32 = 15;
const MARGIN: u32 = 6;

/// Height of the status text in pixels.
pub(super) const HEIGHT: u32 = LINES as u32 * LINE_HEIGHT + 2 * MARGIN;

pub(super) const BACKGROUND: Rgb888 = Rgb888::new(0x14, 0x16, 0x1a);
const PLAIN: Rgb888 = Rgb888::new(0xb8, 0xbe, 0xc8);
const BRIGHT: Rgb888 = Rgb888::WHITE;
/// Color of errors in the status text. The test in `tests/window` searches the window for this
/// color.
pub(super) const ERROR: Rgb888 = Rgb888::new(0xff, 0x6b, 0x5e);

/// Content of the status text.
pub(super) struct Status<'a> {
    pub(super) scene: String,
    /// Index of the scene, and the number of scenes.
    pub(super) place: (usize, usize),
    pub(super) options: String,
    /// Work done so far.
    pub(super) work: &'a Work,
    /// Drawn share of the picture in percent.
    pub(super) percent: u64,
    pub(super) board: Board,
    /// Size of the prepared scene in bytes.
    pub(super) memory: usize,
    /// Size of the renderer and its line buffers in bytes.
    pub(super) renderer: usize,
    pub(super) notice: Notice<'a>,
}

/// Content of the last lines of the status text.
pub(super) enum Notice<'a> {
    Message(&'a str),
    Error(&'a str),
    /// The list of keys, which replaces all other lines.
    Help,
}

type Line = (String, Rgb888);

impl Status<'_> {
    /// Draws the status text.
    pub(super) fn draw<D: DrawTarget<Color = Rgb888>>(
        &self,
        target: &mut D,
    ) -> Result<(), D::Error> {
        target.clear(BACKGROUND)?;
        let width = target.bounding_box().size.width - 2 * MARGIN;
        let columns = (width / FONT_6X13.character_size.width) as usize;
        let lines = self.lines(columns).into_iter().take(LINES);
        for ((text, color), number) in lines.zip(0..) {
            let corner = Point::new(MARGIN as i32, (MARGIN + number * LINE_HEIGHT) as i32);
            let style = MonoTextStyle::new(&FONT_6X13, color);
            Text::with_baseline(&text, corner, style, Baseline::Top).draw(target)?;
        }
        Ok(())
    }

    fn lines(&self, columns: usize) -> Vec<Line> {
        if let Notice::Help = self.notice {
            return HELP.map(|text| (text.to_owned(), PLAIN)).into();
        }
        let mut lines = vec![
            (self.title(), BRIGHT),
            (self.work(), PLAIN),
            (self.memory(), PLAIN),
        ];
        match self.notice {
            Notice::Error(text) => {
                lines.extend(wrapped(text, columns).map(|line| (line, ERROR)));
            }
            Notice::Message(text) => lines.extend(wrapped(text, columns).map(|line| (line, PLAIN))),
            Notice::Help => {}
        }
        lines
    }

    pub(super) fn title(&self) -> String {
        let (place, count) = self.place;
        let Self { scene, options, .. } = self;
        format!("{scene} ({} of {count}) on {options}", place + 1)
    }

    /// Formats the work that the renderer has done so far, and its estimated time on the selected
    /// board.
    fn work(&self) -> String {
        let Stats {
            camera,
            reflected,
            transmitted,
            shadow,
            ..
        } = self.work.stats;
        let rays = [camera, reflected, transmitted].map(u64::from).iter().sum();
        let [rays, shadow] = [rays, shadow.into()].map(grouped);
        let Board {
            title,
            chip,
            megahertz,
            ..
        } = self.board;
        let seconds = self.board.seconds(self.work);
        format!(
            "{} % drawn: {rays} rays, {shadow} shadow rays, about {} on a {title} at {megahertz} MHz ({chip})",
            self.percent,
            duration(seconds)
        )
    }

    fn memory(&self) -> String {
        let bytes = [self.memory, self.renderer];
        let [scene, renderer] = bytes.map(|bytes| grouped(bytes as u64));
        format!("memory: scene {scene} bytes, renderer {renderer} bytes")
    }
}

/// Breaks a text into lines of at most `columns` columns. Lines break between words.
fn wrapped(text: &str, columns: usize) -> impl Iterator<Item = String> {
    text.lines().flat_map(move |line| {
        let mut lines = vec![String::new()];
        for word in line.trim().split(' ') {
            match lines.last_mut() {
                Some(last) if last.is_empty() => last.push_str(word),
                Some(last) if last.chars().count() + 1 + word.chars().count() <= columns => {
                    last.push(' ');
                    last.push_str(word);
                }
                _ => lines.push(word.to_owned()),
            }
        }
        lines
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wraps_long_lines_between_words() {
        let lines: Vec<_> = wrapped("one two three\n  help: four", 8).collect();
        assert_eq!(lines, ["one two", "three", "help:", "four"]);
    }
}
