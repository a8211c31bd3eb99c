use core::fmt;

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_5X8},
    pixelcolor::Gray4,
    prelude::*,
    text::{Baseline, Text},
};

const CELL: Size = FONT_5X8.character_size;

/// Types text on a display: from the top, broken between words.
pub(crate) struct Page<'d, D> {
    display: &'d mut D,
    cursor: Point,
}

impl<'d, D: DrawTarget<Color = Gray4> + OriginDimensions> Page<'d, D> {
    /// A page that starts at the top left.
    pub(crate) fn new(display: &'d mut D) -> Self {
        Self {
            display,
            cursor: Point::zero(),
        }
    }

    fn word(&mut self, word: &str) -> Result<(), D::Error> {
        let style = MonoTextStyle::new(&FONT_5X8, Gray4::WHITE);
        let width = word.trim_end_matches(' ').len() as i32 * CELL.width as i32;
        if self.cursor.x + width > self.display.size().width as i32 {
            self.cursor = Point::new(0, self.cursor.y + CELL.height as i32);
        }
        let text = Text::with_baseline(word, self.cursor, style, Baseline::Top);
        self.cursor = text.draw(self.display)?;
        Ok(())
    }
}

impl<D: DrawTarget<Color = Gray4> + OriginDimensions> fmt::Write for Page<'_, D> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for word in text.split_inclusive(' ') {
            self.word(word).map_err(|_| fmt::Error)?;
        }
        Ok(())
    }
}
